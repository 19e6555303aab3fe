// mutant: y has no part in the distance
// task: circle_overlaps_box
// caught by: overlap-inside
// says: without one of its axes
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double dx = circle.x - nearest_x;
    return dx * dx <= (double)circle.radius * circle.radius;
