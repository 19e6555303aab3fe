// mutant: the distance at right angles to the axis
// task: cone_misses_sphere
// caught by: cone-hair
// says: right angles to the
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    return aside - along * cone.sine / cone.cosine > fabs(radius);
