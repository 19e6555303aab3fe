// mutant: the distance from the eye for that from the axis
// task: cone_misses_sphere
// caught by: cone-clear
// says: from the eye
    const float along = dot(centre, cone.axis);
    const float aside = length(centre);
    return aside * cone.cosine - along * cone.sine > fabs(radius);
