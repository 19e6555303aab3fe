// mutant: a cell wholly inside the sphere, or the reverse, is not seen: only the surface counts
// task: sphere_overlaps_box
// caught by: overlap-inside
// says: centre is in the cell
// looks: missing-in-cell
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    double distance_squared = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double min = box.min[axis], max = box.max[axis];
        const double nearest = centre[axis] < min ? min : centre[axis] > max ? max : centre[axis];
        distance_squared += (centre[axis] - nearest) * (centre[axis] - nearest);
    }
    return distance_squared > 0 && distance_squared <= (double)sphere.radius * sphere.radius;
