// mutant: squares are double, but differences float
// task: circle_overlaps_box
// caught by: overlap-boundary
// says: rounded to float
    const float dx = circle.x - fmaxf(box.minX, fminf(circle.x, box.maxX));
    const float dy = circle.y - fmaxf(box.minY, fminf(circle.y, box.maxY));
    return (double)dx * dx + (double)dy * dy <= (double)circle.radius * circle.radius;
