// right: every id is written, and kept only when it overlaps
// task: distribute
    u32 *end = child_ids;
    for (const u32 *id = ids; id != ids + n_ids; id++) {
        *end = *id;
        end += circle_overlaps_box(h_circles[*id], child) != 0;
    }
    return (u32)(end - child_ids);
