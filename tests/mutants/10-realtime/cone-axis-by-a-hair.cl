// mutant: the axis for the cone: seen where all is a hair
// task: cone_misses_sphere
// caught by: cone-hair
// says: cone were its axis
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside > fabs(radius);
