// mutant: the normal is mirrored at the direction
// task: mirrored_direction
// caught by: mirror-direction
// says: normal was mirrored
    return normal - 2.0f * dot(direction, normal) * direction;
