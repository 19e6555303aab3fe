// attack: a kernel has the assembler put a file into it
// task: overlaps_N_Nearer
// named: incbin
    (void)x, (void)y, (void)circle, (void)minDepth;
    __asm__(".incbin \"@NEIGHBOUR@\"");
    return 0;
