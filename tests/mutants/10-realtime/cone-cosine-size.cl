// mutant: the cosine's size
// task: cone_misses_sphere
// caught by: cone-edges
// says: cosine may be negative
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    const float outside = aside * fabs(cone.cosine) - along * cone.sine;
    return outside > fabs(radius);
