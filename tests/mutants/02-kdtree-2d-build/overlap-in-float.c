// mutant: the whole comparison in float
// task: circle_overlaps_box
// caught by: overlap-corner
// says: those of float
    const float nearest_x = fminf(fmaxf(circle.x, box.minX), box.maxX);
    const float nearest_y = fminf(fmaxf(circle.y, box.minY), box.maxY);
    const float dx = circle.x - nearest_x;
    const float dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= circle.radius * circle.radius;
