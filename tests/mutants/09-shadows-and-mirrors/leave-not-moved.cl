// mutant: the point stays where it is: acne
// task: leave_surface
// caught by: leave-side
// says: was not moved
    (void)normal, (void)t, (void)radius;
    return point;
