// fault: the next id is read ahead of its turn, also behind the last one
// lab: 02-kdtree-2d-build
// task: distribute
// says: an index or a pointer beyond the end
    u32 n_child_ids = 0, next = ids[0];
    for (u32 i = 0; i < n_ids; i++) {
        const u32 circle_id = next;
        next = ids[i + 1];  // HERE
        if (circle_overlaps_box(h_circles[circle_id], child)) {
            child_ids[n_child_ids++] = circle_id;
        }
    }
    return n_child_ids;
