// mutant: nothing is left out
// task: cone_misses_sphere
// caught by: cone-clear
// says: found 0, expected 1
    (void)centre, (void)radius;
    return cone.sine > 2.0f;
