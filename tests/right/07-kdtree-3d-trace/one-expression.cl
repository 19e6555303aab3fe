// right: one expression
// task: near_side
    return origin == node.split_pos ? inverse > 0.0f : origin > node.split_pos;
