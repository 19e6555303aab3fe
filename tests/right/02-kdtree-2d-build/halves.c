// right: recursion: the first half of the ids, then the second behind it
// task: distribute
    if (n_ids == 0) {
        return 0;
    }
    if (n_ids == 1) {
        child_ids[0] = ids[0];
        return circle_overlaps_box(h_circles[ids[0]], child) ? 1 : 0;
    }
    const u32 half = n_ids / 2;
    const u32 n_first = distribute(h_circles, ids, half, child, child_ids);
    return n_first + distribute(h_circles, ids + half, n_ids - half, child, child_ids + n_first);
