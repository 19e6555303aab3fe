// mutant: with the eye on the plane the side that the ray comes from
// task: near_side
// caught by: side-on-plane
// says: comes from
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    return inverse < 0.0f;
