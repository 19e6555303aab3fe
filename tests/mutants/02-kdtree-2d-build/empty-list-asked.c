// mutant: a first circle is asked, even of an empty list
// task: distribute
// caught by: distribute-list
// says: empty list
    u32 n = 0, i = 0;
    do {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n++] = ids[i];
        }
    } while (++i < n_ids);
    return n;
