// mutant: eye and plane are compared as whole numbers
// task: near_side
// caught by: side-eye
// says: whole numbers
    const int eye = (int)origin, plane = (int)node.split_pos;
    if (eye == plane) {
        return inverse > 0.0f ? 1 : 0;
    }
    return eye > plane ? 1 : 0;
