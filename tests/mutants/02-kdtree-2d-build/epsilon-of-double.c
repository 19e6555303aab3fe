// mutant: an epsilon for double is added, in case of rounding
// task: circle_overlaps_box
// caught by: overlap-corner
// says: epsilon
    const double dx = circle.x - fmin(fmax(circle.x, box.minX), box.maxX);
    const double dy = circle.y - fmin(fmax(circle.y, box.minY), box.maxY);
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius * (1 + 1e-15);
