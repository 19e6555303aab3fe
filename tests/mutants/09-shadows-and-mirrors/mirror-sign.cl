// mutant: the sign: into the ball
// task: mirrored_direction
// caught by: mirror-direction
// says: turned round: the sign
    return 2.0f * dot(direction, normal) * normal - direction;
