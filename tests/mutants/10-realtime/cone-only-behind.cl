// mutant: only what is behind the eye is left out
// task: cone_misses_sphere
// caught by: cone-edges
// says: behind the eye
    return -dot(centre, cone.axis) > fabs(radius);
