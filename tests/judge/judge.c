// The table of judges.
#include "judge.h"

#include "number.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

extern const Judge judge_00, judge_01, judge_02, judge_03, judge_04, judge_05, judge_06, judge_07;
static const Judge *const judges[] = {&judge_00, &judge_01, &judge_02, &judge_03,
                                      &judge_04, &judge_05, &judge_06, &judge_07};

const Verdict verdict_missing = {VERDICT_MISSING, NULL};

Verdict verdict_of(char *message)
{
    return (Verdict){message ? VERDICT_FAILED : VERDICT_PASSED, message};
}

int verdict_passes(Verdict verdict)
{
    free(verdict.message);
    return verdict.kind == VERDICT_PASSED;
}

const Judge *judge_of(const char *lab)
{
    uint64_t number;
    const int is_number = number_read_unsigned(lab, 0, 99, &number) == 0;
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++) {
        const char *name = judges[i]->lab;
        if (is_number ? strtoul(name, NULL, 10) == number : strcmp(name, lab) == 0) {
            return judges[i];
        }
    }
    return NULL;
}
