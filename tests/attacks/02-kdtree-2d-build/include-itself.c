// attack: includes itself, without an end
// task: split_box
// named: kdtree2d_build.c
// limit: 3
#include "kdtree2d_build.c"
