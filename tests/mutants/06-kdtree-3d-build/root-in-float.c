// mutant: the distance itself in float, compared with the radius
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: those of float
    const float dx = (float)outside(sphere.x, box.min[0], box.max[0]);
    const float dy = (float)outside(sphere.y, box.min[1], box.max[1]);
    const float dz = (float)outside(sphere.z, box.min[2], box.max[2]);
    return sqrtf(dx * dx + dy * dy + dz * dz) <= fabsf(sphere.radius);
