// mutant: a hundred thousandth of the radius more
// task: cone_misses_sphere
// caught by: cone-hair
// says: without an epsilon
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine - along * cone.sine > fabs(radius) * (1.0f + 1e-5f);
