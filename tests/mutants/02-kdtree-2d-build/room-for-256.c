// mutant: the ids go through an array of 256
// task: distribute
// caught by: distribute-list
// says: ends after 256 ids
// looks: missing-in-cell
    u32 kept[256], n_kept = 0;
    for (u32 i = 0; i < n_ids && n_kept < 256; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            kept[n_kept++] = ids[i];
        }
    }
    for (u32 i = 0; i < n_kept; i++) {
        child_ids[i] = kept[i];
    }
    return n_kept;
