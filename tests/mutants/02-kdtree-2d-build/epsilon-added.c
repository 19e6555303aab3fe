// mutant: a millionth is added, to be on the safe side
// task: circle_overlaps_box
// caught by: overlap-boundary
// says: epsilon
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius + 1e-6;
