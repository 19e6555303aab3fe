// mutant: plus in the place of minus
// task: mirrored_direction
// caught by: mirror-direction
// says: should turn round
    return direction + 2.0f * dot(direction, normal) * normal;
