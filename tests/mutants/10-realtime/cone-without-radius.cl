// mutant: the centre for the sphere
// task: cone_misses_sphere
// caught by: cone-clear
// says: sphere were its centre
    (void)radius;
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > 0.0f;
