// mutant: sine and cosine swapped: seen by far
// task: cone_misses_sphere
// caught by: cone-clear
// says: sine and cosine
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside * cone.sine - along * cone.cosine > fabs(radius);
