// mutant: ids are counted on from the first
// task: distribute
// caught by: distribute-list
// says: counted on
// looks: missing-in-cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const u32 id = ids[0] + i;
        if (circle_overlaps_box(h_circles[id], child)) {
            child_ids[n++] = id;
        }
    }
    return n;
