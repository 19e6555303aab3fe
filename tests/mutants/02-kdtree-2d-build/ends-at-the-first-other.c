// mutant: the loop ends at the first circle that does not overlap
// task: distribute
// caught by: distribute-list
// says: later ones may
// looks: missing-in-cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (!circle_overlaps_box(h_circles[ids[i]], child)) {
            break;
        }
        child_ids[n++] = ids[i];
    }
    return n;
