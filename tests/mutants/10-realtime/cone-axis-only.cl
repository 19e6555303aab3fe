// mutant: the axis for the cone
// task: cone_misses_sphere
// caught by: cone-clear
// says: cone were its axis
    const float along = dot(centre, cone.axis);
    return length(centre - along * cone.axis) > fabs(radius);
