// mutant: with the eye on the plane a direction of less than 1e-4 counts as along it
// task: near_side
// caught by: side-on-plane
// says: however small
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    return inverse > 1e-4f;
