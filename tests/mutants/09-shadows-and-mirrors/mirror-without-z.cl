// mutant: the dot product lacks z
// task: mirrored_direction
// caught by: mirror-direction
// says: z is missing
    const float along = direction.x * normal.x + direction.y * normal.y;
    return direction - 2.0f * along * normal;
