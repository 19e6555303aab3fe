// The table of one judge, THE_JUDGE, for a handout of its lab: whoever takes it apart finds neither
// this lab's solution, which its judge may not use, nor later labs', which other judges use.
#include "home_seeds.h"
#include "judge.h"

extern const Judge THE_JUDGE;

const Judge *const judges[] = {&THE_JUDGE, NULL};
const uint64_t judges_tell_below = HOME_SEEDS;
