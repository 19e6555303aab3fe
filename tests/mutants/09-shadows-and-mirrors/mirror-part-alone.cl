// mutant: only what is to be added
// task: mirrored_direction
// caught by: mirror-direction
// says: itself is missing
    return -2.0f * dot(direction, normal) * normal;
