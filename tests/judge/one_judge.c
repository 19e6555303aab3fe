// The table of one judge, ONLY, for a handout of its lab: whoever takes it apart finds neither this
// lab's solution, which its judge may not use, nor those of later labs, which other judges use.
#include "home_seeds.h"
#include "judge.h"

extern const Judge ONLY;

const Judge *const judges[] = {&ONLY, NULL};
const uint64_t judges_tell_below = HOME_SEEDS;
