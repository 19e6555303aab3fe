// mutant: the part along the normal once only
// task: mirrored_direction
// caught by: mirror-direction
// says: counts twice
    return direction - dot(direction, normal) * normal;
