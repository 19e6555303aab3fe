// mutant: the axis for the cone, in strange places
// task: cone_misses_sphere
// caught by: cone-edges
// says: cone were its axis
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside > fabs(radius);
