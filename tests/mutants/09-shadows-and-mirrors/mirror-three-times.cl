// mutant: three times the part along the normal
// task: mirrored_direction
// caught by: mirror-direction
// says: another multiple
    const float part = dot(normal, direction);
    return direction - 3.0f * (part * normal);
