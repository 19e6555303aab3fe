// attack: writes over 1 MB from its own variables upwards: PoCL runs it in the host's process
// task: overlaps_N_Nearer
// named: crashed|did not finish in time
// limit: 3
    (void)x, (void)y, (void)circle, (void)minDepth;
    volatile uchar own = 0;
    volatile uchar *byte = &own;
    for (int i = 0; i < (1 << 20); i++) {
        byte[i] = 0x41;
    }
    return own;
