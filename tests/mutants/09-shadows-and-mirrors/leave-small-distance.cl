// mutant: a millionth everywhere, about as much as a coordinate is rounded by
// task: leave_surface
// caught by: leave-side
// says: same distance everywhere
    (void)t, (void)radius;
    return point + 1e-6f * normal;
