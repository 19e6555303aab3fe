// right: one guard a direction, unsigned comparisons
// task: own_pixel
    const int y = (int)get_global_id(1);
    if ((uint)y >= (uint)height) {
        return;
    }
    const int x = (int)get_global_id(0);
    if (!(x < width)) {
        return;
    }
