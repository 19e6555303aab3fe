// mutant: in one of the axes it is near enough
// task: circle_overlaps_box
// caught by: overlap-inside
// says: both of them together
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    const double r = circle.radius;
    return dx * dx <= r * r || dy * dy <= r * r;
