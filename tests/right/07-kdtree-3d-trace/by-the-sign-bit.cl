// right: with the eye on the plane the sign bit decides, also of 0 and of an infinite number
// task: near_side
    const float distance = origin - node.split_pos;
    return distance > 0.0f || (distance == 0.0f && !signbit(inverse));
