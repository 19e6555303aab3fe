// mutant: a thousandth everywhere
// task: leave_surface
// caught by: leave-scale
// says: same distance everywhere
    (void)t, (void)radius;
    return point + 0.001f * normal;
