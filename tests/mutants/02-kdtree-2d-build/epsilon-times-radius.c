// mutant: the radius grows by a millionth of itself
// task: circle_overlaps_box
// caught by: overlap-corner
// says: epsilon
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return sqrt(dx * dx + dy * dy) <= circle.radius * (1 + 1e-6);
