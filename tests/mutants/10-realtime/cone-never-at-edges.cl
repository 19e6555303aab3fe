// mutant: nothing is left out, nor in strange places
// task: cone_misses_sphere
// caught by: cone-edges
// says: ever missed
    (void)centre, (void)radius;
    return cone.sine > 2.0f;
