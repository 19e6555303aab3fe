// mutant: the radius is taken for the diameter
// task: circle_overlaps_box
// caught by: overlap-corner
// says: half the radius
// looks: missing-in-cell
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    const double r = circle.radius / 2.0;
    return dx * dx + dy * dy <= r * r;
