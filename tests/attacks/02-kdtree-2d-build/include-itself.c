// attack: includes itself, twice each time
// task: split_box
// named: kdtree2d_build.c
#include "kdtree2d_build.c"
#include "kdtree2d_build.c"
