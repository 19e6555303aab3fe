// right: each pair of faces by itself
// task: surface_area
    double area = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int next = (axis + 1) % 3;
        area += 2 * ((double)box.max[axis] - box.min[axis]) *
                ((double)box.max[next] - box.min[next]);
    }
    return area;
