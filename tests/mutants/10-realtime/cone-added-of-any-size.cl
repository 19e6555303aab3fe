// mutant: the width of the cone is added, in strange places
// task: cone_misses_sphere
// caught by: cone-edges
// says: grows wider
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine + along * cone.sine > fabs(radius);
