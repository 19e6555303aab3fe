// mutant: y is clamped by the upper border of x, which is asked first
// task: circle_overlaps_box
// caught by: overlap-corner
// says: border of the other
// looks: missing-in-cell
    const double x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double y = fmax(fmin(circle.y, box.maxX), box.minY);
    const double dx = x - circle.x, dy = y - circle.y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
