// mutant: coordinates are multiplied one by one
// task: mirrored_direction
// caught by: mirror-direction
// says: a dot product
    return direction - 2.0f * direction * normal * normal;
