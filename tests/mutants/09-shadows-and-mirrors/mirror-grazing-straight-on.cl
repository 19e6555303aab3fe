// mutant: a ray that grazes the mirror goes on
// task: mirrored_direction
// caught by: mirror-edges
// says: without an epsilon
    const float along = dot(direction, normal);
    return along > -0.01f ? direction : direction - 2.0f * along * normal;
