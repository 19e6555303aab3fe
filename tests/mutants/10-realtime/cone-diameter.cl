// mutant: the diameter for the radius
// task: cone_misses_sphere
// caught by: cone-clear
// says: twice the radius
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > 2.0f * fabs(radius);
