// mutant: within the cell a negative distance is squared
// task: circle_overlaps_box
// caught by: overlap-inside
// says: corners alone
// looks: missing-in-cell
    const double dx = fmax((double)box.minX - circle.x, (double)circle.x - box.maxX);
    const double dy = fmax((double)box.minY - circle.y, (double)circle.y - box.maxY);
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
