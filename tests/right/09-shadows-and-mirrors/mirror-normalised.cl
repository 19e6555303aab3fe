// right: made a unit vector again
// task: mirrored_direction
    return normalize(direction - 2.0f * dot(direction, normal) * normal);
