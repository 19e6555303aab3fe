// mutant: an eye near the plane counts as one on it
// task: near_side
// caught by: side-eye
// says: epsilon
    if (origin < node.split_pos - 0.01f) {
        return 0;
    }
    if (origin > node.split_pos + 0.01f) {
        return 1;
    }
    return inverse > 0.0f;
