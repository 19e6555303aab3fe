// mutant: only the cell's corners are asked: a circle inside the cell is missed
// task: circle_overlaps_box
// caught by: overlap-inside
// says: found 0, expected 1
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
    return 0;
