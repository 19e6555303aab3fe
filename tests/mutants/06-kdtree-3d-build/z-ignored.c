// mutant: the third axis is ignored
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: without one of its axes
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    double distance_squared = 0;
    for (int axis = 0; axis < 2; axis++) {
        const double min = box.min[axis], max = box.max[axis];
        const double nearest = centre[axis] < min ? min : centre[axis] > max ? max : centre[axis];
        distance_squared += (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return distance_squared <= (double)sphere.radius * sphere.radius;
