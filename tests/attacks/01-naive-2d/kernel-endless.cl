// attack: a kernel without an end
// task: overlaps_N_Nearer
// named: did not finish in time
// limit: 4
    (void)circle, (void)minDepth;
    for (volatile int i = x;; i++) {
    }
    return y;
