// mutant: a ray that all but goes along the mirror goes straight on
// task: mirrored_direction
// caught by: mirror-edges
// says: without an epsilon
    if (dot(direction, normal) > -1e-5f) {
        return direction;
    }
    return direction - 2.0f * dot(direction, normal) * normal;
