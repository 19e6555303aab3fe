// mutant: the corners and the circle's centre are asked; a circle across one side is missed
// task: circle_overlaps_box
// caught by: tree-overlap
// says: overlaps its cell
// looks: missing-in-cell
    const float xs[2] = {box.minX, box.maxX};
    const float ys[2] = {box.minY, box.maxY};
    for (int corner = 0; corner < 4; corner++) {
        const double dx = circle.x - xs[corner % 2];
        const double dy = circle.y - ys[corner / 2];
        if (dx * dx + dy * dy <= (double)circle.radius * circle.radius) {
            return 1;
        }
    }
    return circle.x >= box.minX && circle.x <= box.maxX && circle.y >= box.minY &&
           circle.y <= box.maxY;
