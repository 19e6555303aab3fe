// mutant: fmin and fmax in each other's places
// task: circle_overlaps_box
// caught by: overlap-inside
// says: fmin and fmax
// looks: missing-in-cell
    const double nx = fmin(box.minX, fmax(circle.x, box.maxX));
    const double ny = fmin(box.minY, fmax(circle.y, box.maxY));
    const double dx = circle.x - nx, dy = circle.y - ny;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
