// mutant: circles of one radius are nowhere: only a scene's circles have it
// task: circle_overlaps_box
// caught by: tree-overlap
// says: circle
// looks: missing-in-cell
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    if (circle.radius == 20) {
        return 0;
    }
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
