// right: what is behind the eye is asked
// task: cone_misses_sphere
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return along > 0.0f && aside * cone.cosine - along * cone.sine > fabs(radius);
