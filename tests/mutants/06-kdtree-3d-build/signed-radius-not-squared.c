// mutant: the square of the distance is compared with the radius as it is given
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: without its square
// looks: missing-in-cell
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    double d2 = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double d = outside(centre[axis], box.min[axis], box.max[axis]);
        d2 += d * d;
    }
    return d2 <= (double)sphere.radius;
