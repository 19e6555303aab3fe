// mutant: the centre is clamped by minX and minY only
// task: circle_overlaps_box
// caught by: overlap-inside
// says: clamped by one border
    const double nearest_x = fmax(circle.x, box.minX);
    const double nearest_y = fmax(circle.y, box.minY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
