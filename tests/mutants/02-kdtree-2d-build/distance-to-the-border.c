// mutant: the distance to the border, also from within
// task: circle_overlaps_box
// caught by: overlap-inside
// says: within the cell
// looks: missing-in-cell
    const double left = fabs((double)circle.x - box.minX), right = fabs((double)circle.x - box.maxX);
    const double top = fabs((double)circle.y - box.minY), bottom = fabs((double)circle.y - box.maxY);
    const int in_x = circle.x >= box.minX && circle.x <= box.maxX;
    const int in_y = circle.y >= box.minY && circle.y <= box.maxY;
    const double dx = fmin(left, right), dy = fmin(top, bottom), r = circle.radius;
    if (in_x && in_y)
        return fmin(dx, dy) <= r;
    if (in_x)
        return dy <= r;
    if (in_y)
        return dx <= r;
    return dx * dx + dy * dy <= r * r;
