// mutant: a small distance more
// task: cone_misses_sphere
// caught by: cone-edges
// says: without an epsilon
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > fabs(radius) + 0.001f;
