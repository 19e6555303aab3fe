// mutant: the distances on the axes are added, not their squares
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: distances on the axes
// looks: missing-in-cell
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    double distance_squared = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double min = box.min[axis], max = box.max[axis];
        const double nearest = centre[axis] < min ? min : centre[axis] > max ? max : centre[axis];
        distance_squared += fabs(centre[axis] - nearest);
    }
    return distance_squared <= fabs((double)sphere.radius);
