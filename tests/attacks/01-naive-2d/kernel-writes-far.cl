// attack: writes to addresses of its own choice
// task: overlaps_N_Nearer
// named: crashed
    (void)x, (void)y, (void)circle, (void)minDepth;
    for (ulong address = 0x1000; address < 0x7fffffffffff; address = address * 3 + 1) {
        *(volatile int *)address = 100;
    }
    return 1;
