// right: all ids copied first, then those that do not belong are closed over
// task: distribute
    u32 n_kept = 0;
    for (u32 i = 0; i < n_ids; i++) {
        child_ids[i] = ids[i];
    }
    for (u32 i = 0; i < n_ids; i++) {
        if (!circle_overlaps_box(h_circles[child_ids[i]], child)) {
            continue;
        }
        child_ids[n_kept] = child_ids[i];
        n_kept++;
    }
    return n_kept;
