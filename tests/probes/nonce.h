// The number that stands for NONCE in the stubs (tests/stubs/README.md).
//
// The grader writes it into their text, and the judge computes with it: so what they do can be
// foreseen by the judge, and by nobody who only knows their text and the job's inputs.
#ifndef PROBES_NONCE_H
#define PROBES_NONCE_H

#include "one_way.h"

static inline uint32_t stub_nonce(uint64_t seed)
{
    return (uint32_t)one_way(seed, PURPOSE_NONCE);
}

#endif
