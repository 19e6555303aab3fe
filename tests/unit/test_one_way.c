// probes/one_way: what a run sees of a job tells neither the seed nor the nonce.
//
// That jobs are drawn so is in test_judges.c.
#include "one_way.h"

#include "nonce.h"

#include <criterion/criterion.h>

// From the authors' table of test vectors: key and message are the bytes 0, 1, 2, ...
Test(one_way, siphash_is_siphash)
{
    cr_expect_eq(siphash(0x0706050403020100u, 0x0f0e0d0c0b0a0908u, 0x0706050403020100u),
                 0x93f5f5799a932462u);
}

Test(one_way, purposes_and_seeds_are_told_apart)
{
    cr_expect_neq(one_way(1, PURPOSE_INPUTS), one_way(2, PURPOSE_INPUTS));
    cr_expect_neq(one_way(1, PURPOSE_INPUTS), one_way(1, PURPOSE_NONCE));
    cr_expect_neq((uint32_t)one_way(1, PURPOSE_INPUTS), stub_nonce(1));
}
