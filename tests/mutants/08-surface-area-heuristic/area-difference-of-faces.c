// mutant: one product is taken off
// task: surface_area
// caught by: area-boxes
// says: three products added
    double sides[3];
    for (int axis = 0; axis < 3; axis++) {
        sides[axis] = (double)box.max[axis] - (double)box.min[axis];
    }
    return 2 * sides[0] * sides[1] + 2 * sides[1] * sides[2] - 2 * sides[2] * sides[0];
