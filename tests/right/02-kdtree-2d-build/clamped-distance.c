// right: the distance beyond each border, clamped at 0; the root at the end
// task: circle_overlaps_box
    const double dx = fmax(0, fmax((double)box.minX - circle.x, (double)circle.x - box.maxX));
    const double dy = fmax(0, fmax((double)box.minY - circle.y, (double)circle.y - box.maxY));
    if (dx > circle.radius || dy > circle.radius) {
        return 0;
    }
    const double left_over = (double)circle.radius * circle.radius - dx * dx;
    return dy * dy <= left_over;
