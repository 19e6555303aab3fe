// right: the distance is by how much the centre is farther from the cell's middle than half its side
// task: circle_overlaps_box
    const double half_x = ((double)box.maxX - box.minX) / 2;
    const double half_y = ((double)box.maxY - box.minY) / 2;
    const double dx = fabs(circle.x - ((double)box.minX + half_x)) - half_x;
    const double dy = fabs(circle.y - ((double)box.minY + half_y)) - half_y;
    double squares = 0;
    if (dx > 0) {
        squares += dx * dx;
    }
    if (dy > 0) {
        squares += dy * dy;
    }
    return squares <= (double)circle.radius * circle.radius;
