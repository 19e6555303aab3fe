// 2D: from the line that includes this header on, calls of the two functions are counted in *work
// of work.h. A macro is not expanded inside its own expansion, so the inner name is the function
// itself. Parameters are named one by one: OpenCL C knows no variadic macros.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: work.h.
#ifdef COUNT_WORK
#define overlaps_N_Nearer(x, y, circle, minDepth)                                                  \
    (work->n_tests++, overlaps_N_Nearer(x, y, circle, minDepth))
#define getContainingChild(x, y, id, nodes_Relations, nodes_BBox)                                  \
    (work->n_nodes_visited++, getContainingChild(x, y, id, nodes_Relations, nodes_BBox))
#endif
