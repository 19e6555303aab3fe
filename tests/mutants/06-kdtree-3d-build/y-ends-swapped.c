// mutant: on y the maximum comes before the minimum
// task: sphere_overlaps_box
// caught by: overlap-touching
// says: in this order
// looks: missing-in-cell
    const double distances[] = {outside(sphere.x, box.min[0], box.max[0]),
                                outside(sphere.y, box.max[1], box.min[1]),
                                outside(sphere.z, box.min[2], box.max[2])};
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        sum += distances[axis] * distances[axis];
    }
    return sum <= (double)sphere.radius * sphere.radius;
