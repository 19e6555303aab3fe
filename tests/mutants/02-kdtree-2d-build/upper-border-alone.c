// mutant: the nearest y is clamped by the upper border alone
// task: circle_overlaps_box
// caught by: overlap-inside
// says: clamped by one border
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(circle.y, box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
