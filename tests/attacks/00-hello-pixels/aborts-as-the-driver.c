// attack: the program ends as the driver's compiler does when it gives up, to be excused
// task: read_back
// named: signal 6
// never: driver's compiler|LLVM ERROR. *, which may be right
    (void)queue, (void)d_image, (void)width, (void)height, (void)h_pixels;
    extern int dprintf(int, const char *, ...);
    extern void abort(void);
    dprintf(2, "LLVM ERROR: Instruction Combining did not reach a fixpoint after 1 iterations\n");
    abort();
