// mutant: a sphere behind the eye is missed, also for a tile of half a view
// task: cone_misses_sphere
// caught by: cone-edges
// says: rays go to all sides
    const float along = dot(centre, cone.axis);
    const float aside = length(centre - along * cone.axis);
    if (along < -fabs(radius)) {
        return 1;
    }
    const float outside = aside * cone.cosine - along * cone.sine;
    return outside > fabs(radius);
