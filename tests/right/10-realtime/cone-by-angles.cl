// right: by angles; behind the border's foot the eye is nearest
// task: cone_misses_sphere
    const float along = dot(centre, cone.axis);
    const float aside = length(cross(centre, cone.axis));
    const float beyond = atan2(aside, along) - atan2(cone.sine, cone.cosine);
    // Behind the border's foot the centre itself is nearest.
    return beyond > 0.0f && length(centre) * (beyond < M_PI_2_F ? sin(beyond) : 1.0f) > fabs(radius);
