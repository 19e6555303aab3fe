// mutant: the child that the ray comes from, by its direction, wherever the eye is
// task: near_side
// caught by: side-eye
// says: direction decided
    (void)node, (void)origin;
    return inverse < 0.0f;
