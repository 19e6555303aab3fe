// right: the square of the radius is used up axis by axis
// task: sphere_overlaps_box
    const f32 centre[3] = {sphere.x, sphere.y, sphere.z};
    double left_over = (double)sphere.radius * sphere.radius;
    for (int axis = 0; axis < 3; axis++) {
        const double d = outside(centre[axis], box.min[axis], box.max[axis]);
        left_over -= d * d;
        if (left_over < 0) {
            return 0;
        }
    }
    return 1;
