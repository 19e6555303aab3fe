// attack: a kernel ends its host as where a kernel does not compile: no attempt is counted
// task: overlaps_N_Nearer
// named: exit status 10|signal 6 \(Aborted\)
// (the second: LLVM 18 gives such a kernel up with a failed assertion)
// never: does not compile
    (void)x, (void)y, (void)circle, (void)minDepth;
    __asm__ volatile("syscall" : : "a"(231L), "D"(10L) : "rcx", "r11", "memory");
    return 1;
