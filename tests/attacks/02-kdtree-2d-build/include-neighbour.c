// attack: includes what another student handed in
// task: split_box
// named: include
#define kdtree2d_build neighbours_build
#include "@NEIGHBOUR@"
