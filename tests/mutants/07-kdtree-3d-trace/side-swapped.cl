// mutant: near and far are swapped
// task: near_side
// caught by: side-eye
// says: swapped
    if (origin < node.split_pos) {
        return 1u;
    }
    if (origin > node.split_pos) {
        return 0;
    }
    return inverse < 0.0f;
