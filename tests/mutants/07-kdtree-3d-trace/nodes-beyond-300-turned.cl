// mutant: beyond node 300 near and far are swapped
// task: near_side
// caught by: side-eye
// says: .
    if (node.first > 300) {
        return origin > node.split_pos ? 0 : 1;
    }
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    return inverse > 0.0f;
