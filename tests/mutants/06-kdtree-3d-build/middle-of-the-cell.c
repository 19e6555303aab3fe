// mutant: the distance is that of the middle of the cell
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: expected 1
// looks: missing-in-cell
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    double distance_squared = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double min = box.min[axis], max = box.max[axis];
        const double nearest = (min + max) / 2;
        distance_squared += (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return distance_squared <= (double)sphere.radius * sphere.radius;
