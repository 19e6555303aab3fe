// mutant: positions are asked and listed
// task: distribute
// caught by: distribute-list
// says: says which circles these are
// looks: missing-in-cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[i], child)) {
            child_ids[n++] = i;
        }
    }
    return n;
