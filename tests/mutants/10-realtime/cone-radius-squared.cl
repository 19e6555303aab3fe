// mutant: a distance compared with a square
// task: cone_misses_sphere
// caught by: cone-clear
// says: square
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > radius * radius;
