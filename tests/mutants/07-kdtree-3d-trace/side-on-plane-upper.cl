// mutant: an eye on the plane goes to the upper child whatever the direction
// task: near_side
// caught by: side-on-plane
// says: upper child
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    (void)inverse;
    return 1;
