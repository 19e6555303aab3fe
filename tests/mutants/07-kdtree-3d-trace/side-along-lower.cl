// mutant: every ray along the plane goes to the lower child, wherever the eye is
// task: near_side
// caught by: side-eye
// says: along the plane
    if (isinf(inverse) || inverse == 0.0f) {
        return 0;
    }
    if (origin < node.split_pos) {
        return 0;
    }
    if (origin > node.split_pos) {
        return 1;
    }
    return inverse > 0.0f;
