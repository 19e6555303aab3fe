// mutant: near on one axis is enough
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: near on one axis
    double x = outside(sphere.x, box.min[0], box.max[0]);
    double y = outside(sphere.y, box.min[1], box.max[1]);
    double z = outside(sphere.z, box.min[2], box.max[2]);
    double r = sphere.radius;
    return x * x <= r * r || y * y <= r * r || z * z <= r * r;
