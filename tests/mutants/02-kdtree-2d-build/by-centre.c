// mutant: a circle goes where its centre is
// task: distribute
// caught by: distribute-list
// says: centres were asked
// looks: missing-in-cell
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Circle c = h_circles[ids[i]];
        const int centre = c.x >= child.minX && c.x < child.maxX && c.y >= child.minY && c.y < child.maxY;
        if (centre && circle_overlaps_box(c, child)) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
