// mutant: asks whether the ray goes away from the plane
// task: near_side
// caught by: side-eye
// says: goes away
    const float away = (origin - node.split_pos) * inverse;
    return away > 0.0f || (origin == node.split_pos && inverse > 0.0f) ? 1 : 0;
