// mutant: the centre is kept in two ints
// task: circle_overlaps_box
// caught by: overlap-boundary
// says: whole numbers
    const int x = (int)circle.x, y = (int)circle.y;
    const double dx = x - fmin(fmax(x, box.minX), box.maxX);
    const double dy = y - fmin(fmax(y, box.minY), box.maxY);
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
