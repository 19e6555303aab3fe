// mutant: the id of the near child instead of its side
// task: near_side
// caught by: side-eye
// says: id of a child
    if (origin < node.split_pos) {
        return node.first;
    }
    if (origin > node.split_pos) {
        return node.first + 1;
    }
    return node.first + (inverse > 0.0f);
