// mutant: the radius taken off on the other side
// task: cone_misses_sphere
// caught by: cone-hair
// says: wrong side
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine > along * cone.sine - fabs(radius);
