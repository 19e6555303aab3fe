// mutant: the sphere's bounding cube is tested instead of the sphere
// task: sphere_overlaps_box
// caught by: overlap-corner
// says: bounding cube
    const double centre[3] = {sphere.x, sphere.y, sphere.z};
    const double radius = fabs((double)sphere.radius);
    for (int axis = 0; axis < 3; axis++) {
        if (centre[axis] + radius < box.min[axis] || centre[axis] - radius > box.max[axis]) {
            return 0;
        }
    }
    return 1;
