// mutant: twice the dot product is added to each coordinate
// task: mirrored_direction
// caught by: mirror-direction
// says: one number
    const float part = dot(normal, direction);
    return direction + (float3)(2.0f * part);
