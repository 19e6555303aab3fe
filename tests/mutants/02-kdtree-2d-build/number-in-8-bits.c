// mutant: the number of ids is kept in 8 bits
// task: distribute
// caught by: distribute-list
// says: 8 bits
// looks: missing-in-cell
    u8 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
