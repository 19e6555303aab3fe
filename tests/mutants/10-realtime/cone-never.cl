// mutant: nothing is left out
// task: cone_misses_sphere
// caught by: cone-clear
// says: ever missed
    (void)centre, (void)radius;
    return cone.sine > 2.0f;
