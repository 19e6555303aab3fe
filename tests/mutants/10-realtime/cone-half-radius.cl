// mutant: half of the radius
// task: cone_misses_sphere
// caught by: cone-clear
// says: half as large
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > 0.5f * fabs(radius);
