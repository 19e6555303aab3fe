// mutant: the list is sorted by depth
// task: distribute
// caught by: distribute-list
// says: another order
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (!circle_overlaps_box(h_circles[ids[i]], child))
            continue;
        u32 k = n++;
        for (; k > 0 && h_circles[child_ids[k - 1]].depth > h_circles[ids[i]].depth; k--)
            child_ids[k] = child_ids[k - 1];
        child_ids[k] = ids[i];
    }
    return n;
