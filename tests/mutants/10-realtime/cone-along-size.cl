// mutant: the size of the part along the axis
// task: cone_misses_sphere
// caught by: cone-edges
// says: stays so
    const float along = fabs(dot(centre, cone.axis));
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > fabs(radius);
