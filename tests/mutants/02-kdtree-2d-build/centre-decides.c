// mutant: a circle goes only to the child that holds its centre
// task: distribute
// caught by: distribute-list
// says: child_ids\[|returned
// looks: missing-in-cell
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Circle circle = h_circles[ids[i]];
        if (circle.x >= child.minX && circle.x < child.maxX && circle.y >= child.minY &&
            circle.y < child.maxY) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
