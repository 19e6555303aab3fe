// mutant: a square for the length
// task: cone_misses_sphere
// caught by: cone-clear
// says: mixed
    const float along = dot(centre, cone.axis);
    const float aside = dot(centre - along * cone.axis, centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > radius * radius;
