// mutant: centre - axis
// task: cone_misses_sphere
// caught by: cone-clear
// says: unit vector
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - cone.axis);
    return aside * cone.cosine - along * cone.sine > fabs(radius);
