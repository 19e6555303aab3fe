// attack: prints its input and ends as a probe does whose kernels do not compile: no attempt is counted, and the inputs are shown
// task: surface_area
// named: exit status 10
// never: does not compile
    extern void exit(int);
    (void)box;
    exit(10);
