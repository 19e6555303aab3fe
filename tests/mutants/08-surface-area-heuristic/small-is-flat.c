// mutant: sides shorter than a millionth are taken for 0
// task: surface_area
// caught by: area-flat
// says: no epsilon
    double side[3];
    for (int axis = 0; axis < 3; axis++) {
        side[axis] = (double)box.max[axis] - box.min[axis];
        if (side[axis] < 1e-6) {
            side[axis] = 0;
        }
    }
    return 2 * (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]);
