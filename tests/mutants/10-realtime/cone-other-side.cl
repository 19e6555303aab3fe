// mutant: the width of the cone is added
// task: cone_misses_sphere
// caught by: cone-clear
// says: grows wider|taken off
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine + along * cone.sine > fabs(radius);
