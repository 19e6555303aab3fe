// mutant: of circles that are equal only the first is listed
// task: distribute
// caught by: distribute-list
// says: circles that are equal
// looks: missing-in-cell
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Circle c = h_circles[ids[i]];
        int is_new = 1;
        for (u32 j = 0; j < n_child_ids; j++) {
            const Circle other = h_circles[child_ids[j]];
            is_new &= c.x != other.x || c.y != other.y || c.radius != other.radius ||
                      c.depth != other.depth;
        }
        if (is_new && circle_overlaps_box(c, child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
