// The frame that grows 3D trees, with OpenMP (bench.mk): linked into bench3d in the place of
// common's, which has one thread. How many it takes says omp_set_num_threads().
//
// Read next: bench3d.c.
#include "tree3d_grow.c"
