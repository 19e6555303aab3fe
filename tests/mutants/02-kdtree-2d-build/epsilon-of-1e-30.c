// mutant: a very small epsilon is added, in case of rounding
// task: circle_overlaps_box
// caught by: overlap-boundary
// says: epsilon
    const double dx = circle.x - fmin(fmax(circle.x, box.minX), box.maxX);
    const double dy = circle.y - fmin(fmax(circle.y, box.minY), box.maxY);
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius + 1e-30;
