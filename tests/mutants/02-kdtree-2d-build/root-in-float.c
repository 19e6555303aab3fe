// mutant: the distance itself in float, compared with the radius
// task: circle_overlaps_box
// caught by: overlap-corner
// says: those of float
    const float dx = circle.x - fminf(fmaxf(circle.x, box.minX), box.maxX);
    const float dy = circle.y - fminf(fmaxf(circle.y, box.minY), box.maxY);
    return sqrtf(dx * dx + dy * dy) <= circle.radius;
