// mutant: sine and cosine swapped: seen where all is a hair
// task: cone_misses_sphere
// caught by: cone-hair
// says: sine and cosine
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.sine - along * cone.cosine > fabs(radius);
