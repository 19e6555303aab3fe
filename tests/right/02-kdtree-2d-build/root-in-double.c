// right: the distance itself, its root in double; differences of two floats are exact in float here
// task: circle_overlaps_box
    const f32 dx = circle.x - fminf(fmaxf(circle.x, box.minX), box.maxX);
    const f32 dy = circle.y - fminf(fmaxf(circle.y, box.minY), box.maxY);
    return sqrt((double)dx * dx + (double)dy * dy) <= circle.radius;
