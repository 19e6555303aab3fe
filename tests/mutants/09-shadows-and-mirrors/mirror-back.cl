// mutant: the ray goes back
// task: mirrored_direction
// caught by: mirror-direction
// says: back to where
    return -direction + 0.0f * normal;
