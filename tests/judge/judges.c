// The table of judges: those of all folders beside this file.
#include "judge.h"

// JUDGES is from the makefile: JUDGE(00) JUDGE(01) ...
#define JUDGE(number) extern const Judge judge_##number;
JUDGES
#undef JUDGE

#define JUDGE(number) &judge_##number,
const Judge *const judges[] = {JUDGES NULL};
const uint64_t judges_tell_below = UINT64_MAX;
