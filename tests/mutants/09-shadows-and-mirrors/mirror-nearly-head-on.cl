// mutant: what comes within two degrees of the normal goes back along it
// task: mirrored_direction
// caught by: mirror-edges
// says: found
    const float along = dot(direction, normal);
    return along < -0.9994f ? normal : direction - 2.0f * along * normal;
