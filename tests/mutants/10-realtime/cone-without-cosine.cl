// mutant: the cosine is left out
// task: cone_misses_sphere
// caught by: cone-hair
// says: cosine is missing
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    const float outside = aside - along * cone.sine;
    return outside > fabs(radius);
