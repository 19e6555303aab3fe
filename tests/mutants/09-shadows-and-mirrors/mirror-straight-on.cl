// mutant: the ray goes on
// task: mirrored_direction
// caught by: mirror-direction
// says: straight on
    return direction + 0.0f * normal;
