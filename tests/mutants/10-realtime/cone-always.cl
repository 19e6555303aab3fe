// mutant: everything is left out
// task: cone_misses_sphere
// caught by: cone-clear
// says: every sphere were missed
    (void)cone, (void)centre, (void)radius;
    return 1;
