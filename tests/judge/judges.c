// The table of judges: in a judge the one of its lab, in tests those of all labs.
#include "judge.h"

// JUDGES is from the makefile: JUDGE(00) JUDGE(01) ...
#define JUDGE(number) extern const Judge judge_##number;
JUDGES
#undef JUDGE

#define JUDGE(number) &judge_##number,
const Judge *const judges[] = {JUDGES NULL};
