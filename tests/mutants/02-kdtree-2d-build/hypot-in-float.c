// mutant: hypotf, which rounds the distance to float
// task: circle_overlaps_box
// caught by: overlap-corner
// says: those of float
    const float dx = circle.x - fminf(fmaxf(circle.x, box.minX), box.maxX);
    const float dy = circle.y - fminf(fmaxf(circle.y, box.minY), box.maxY);
    return hypotf(dx, dy) <= circle.radius;
