// mutant: the cosine of the angle for the distance along the axis
// task: cone_misses_sphere
// caught by: cone-clear
// says: not the cosine
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    const float outside = aside * cone.cosine - along / length(centre) * cone.sine;
    return outside > fabs(radius);
