// mutant: the circle at the position is asked
// task: distribute
// caught by: distribute-list
// says: at the position
// looks: missing-in-cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[i], child)) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
