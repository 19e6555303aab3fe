// mutant: a ray whose cosine with the mirror is below a millionth goes straight on
// task: mirrored_direction
// caught by: mirror-edges
// says: without an epsilon
    if (dot(direction, normal) > -1e-6f) {
        return direction;
    }
    return direction - 2.0f * dot(direction, normal) * normal;
