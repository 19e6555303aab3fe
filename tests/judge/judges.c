// The table of judges.
#include "judge.h"

extern const Judge judge_00, judge_01, judge_02, judge_03, judge_04, judge_05, judge_06, judge_07,
    judge_08, judge_09, judge_10;

const Judge *const judges[] = {&judge_00, &judge_01, &judge_02, &judge_03, &judge_04, &judge_05,
                               &judge_06, &judge_07, &judge_08, &judge_09, &judge_10, NULL};
const uint64_t judges_tell_below = UINT64_MAX;
