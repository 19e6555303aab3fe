// From the line that includes this header on, calls of the two functions are counted in the variable
// `work` of work.h. A macro is not expanded inside its own expansion, so the inner name is the
// function itself.
#ifdef COUNT_WORK
#define overlaps_N_Nearer(...) (work.n_circle_tests++, overlaps_N_Nearer(__VA_ARGS__))
#define getContainingChild(...) (work.n_nodes_visited++, getContainingChild(__VA_ARGS__))
#endif
