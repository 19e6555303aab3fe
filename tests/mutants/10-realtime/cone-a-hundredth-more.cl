// mutant: a hundredth of the radius more
// task: cone_misses_sphere
// caught by: cone-hair
// says: without an epsilon
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    const float outside = aside * cone.cosine - along * cone.sine;
    return outside > 1.01f * fabs(radius);
