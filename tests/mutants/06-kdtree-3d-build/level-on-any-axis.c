// mutant: level with the cell on one axis is enough
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: level with the cell
    double x = outside(sphere.x, box.min[0], box.max[0]);
    double y = outside(sphere.y, box.min[1], box.max[1]);
    double z = outside(sphere.z, box.min[2], box.max[2]);
    if (x == 0 || y == 0 || z == 0) {
        return 1;
    }
    double r = sphere.radius;
    return x * x + y * y + z * z <= r * r;
