// mutant: a negative radius is less than any distance
// task: cone_misses_sphere
// caught by: cone-edges
// says: negative
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > radius;
