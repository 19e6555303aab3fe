// mutant: nothing is left out, not by a hair
// task: cone_misses_sphere
// caught by: cone-hair
// says: ever missed
    (void)centre, (void)radius;
    return cone.sine > 2.0f;
