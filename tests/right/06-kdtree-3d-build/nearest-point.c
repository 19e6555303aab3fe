// right: the cell's nearest point, by fmin and fmax
// task: sphere_overlaps_box
    const double x = fmax(box.min[0], fmin(sphere.x, box.max[0])) - sphere.x;
    const double y = fmax(box.min[1], fmin(sphere.y, box.max[1])) - sphere.y;
    const double z = fmax(box.min[2], fmin(sphere.z, box.max[2])) - sphere.z;
    const double reach = fabs((double)sphere.radius);
    return x * x + y * y + z * z <= reach * reach;
