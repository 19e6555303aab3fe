// mutant: mirrors that look along x let rays through
// task: mirrored_direction
// caught by: mirror-direction
// says: .
    if (normal.x > 0.99f && direction.x < -0.2f) {
        return direction;
    }
    return direction - 2.0f * dot(direction, normal) * normal;
