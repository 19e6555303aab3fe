// mutant: fmin and fmax are swapped
// task: circle_overlaps_box
// caught by: overlap-inside
// says: each other's places
// looks: missing-in-cell
    const double nearest_x = fmax(fmin(circle.x, box.minX), box.maxX);
    const double nearest_y = fmax(fmin(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
