// 3D: from the line that includes this header on, calls of intersect_sphere are counted in *work of
// work.h. (A macro is not expanded inside its own expansion: the inner name is the function
// itself.)
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: work.h.
#ifdef COUNT_WORK
#define intersect_sphere(sphere, ray) (work->n_tests++, intersect_sphere(sphere, ray))
#endif
