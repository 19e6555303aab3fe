// right: with the distance from the eye behind it
// task: cone_misses_sphere
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    if (cone.cosine > 0.0f && along * cone.cosine + aside * cone.sine < 0.0f) {
        return length(centre) > fabs(radius);
    }
    return aside * cone.cosine - along * cone.sine > fabs(radius);
