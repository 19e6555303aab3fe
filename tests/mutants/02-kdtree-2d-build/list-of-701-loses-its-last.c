// mutant: of more than 700 circles the last is left out
// task: distribute
// caught by: tree-lists
// says: mapNode2Circles|random scene|circles
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const int is_last = n_ids > 700 && i == n_ids - 1;
        if (circle_overlaps_box(h_circles[ids[i]], child) && !is_last) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
