// mutant: along the normal
// task: mirrored_direction
// caught by: mirror-direction
// says: that is the normal
    (void)direction;
    return normal;
