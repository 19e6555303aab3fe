// mutant: 1 where it may be hit
// task: cone_misses_sphere
// caught by: cone-clear
// says: swapped
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine <= fabs(radius);
