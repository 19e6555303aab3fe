// mutant: the right and lower sides of the cell are left out, as for pixels
// task: circle_overlaps_box
// caught by: overlap-boundary
// says: touch
// looks: strict-boundary missing-in-cell
    if (circle.x - circle.radius >= box.maxX || circle.y - circle.radius >= box.maxY) {
        return 0;
    }
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
