// mutant: twice the part, along the direction
// task: mirrored_direction
// caught by: mirror-direction
// says: not along the direction
    return direction - 2.0f * dot(direction, normal) * direction;
