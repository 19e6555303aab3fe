// mutant: the width of the cone is added: seen where all is a hair
// task: cone_misses_sphere
// caught by: cone-hair
// says: grows wider
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.cosine + along * cone.sine > fabs(radius);
