// mutant: the nearest point is kept in an int
// task: circle_overlaps_box
// caught by: overlap-corner
// says: made a whole number
// looks: missing-in-cell
    const int nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const int nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
