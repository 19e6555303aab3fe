// mutant: the largest coordinate for the length
// task: cone_misses_sphere
// caught by: cone-clear
// says: not the largest coordinate
    const float along = dot(centre, cone.axis);
    const float3 beside = fabs(centre - along * cone.axis);
    const float aside = fmax(beside.x, fmax(beside.y, beside.z));
    return aside * cone.cosine - along * cone.sine > fabs(radius);
