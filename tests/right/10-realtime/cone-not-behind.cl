// right: what lies wholly behind the eye is missed, unless rays go to all sides
// task: cone_misses_sphere
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    // A cone that is half a view or less has no ray behind the eye.
    return (cone.cosine > 0.0f && along < -fabs(radius)) ||
           aside * cone.cosine - along * cone.sine > fabs(radius);
