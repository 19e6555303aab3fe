// attack: a kernel asks the compiler which files there are
// task: overlaps_N_Nearer
// named: __has_include
    (void)x, (void)y, (void)circle, (void)minDepth;
#if __has_include("/etc/shadow") || __has_include("@NEIGHBOUR@") || __has_include("@REFERENCE@")
#error LEAKED: there is such a file
#endif
    return 0;
