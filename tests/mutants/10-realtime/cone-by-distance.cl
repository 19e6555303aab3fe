// mutant: the sine of the distance from the eye
// task: cone_misses_sphere
// caught by: cone-hair
// says: along the axis
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - length(centre) * cone.sine > fabs(radius);
