// mutant: an eye below is asked for its direction
// task: near_side
// caught by: side-eye
// says: another
    if (origin <= node.split_pos) {
        return inverse > 0.0f ? 1 : 0;
    }
    return 1;
