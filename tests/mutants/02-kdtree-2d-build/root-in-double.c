// mutant: the root is taken, which double rounds, too
// task: circle_overlaps_box
// caught by: overlap-corner
// says: root
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    return hypot(circle.x - nearest_x, circle.y - nearest_y) <= circle.radius;
