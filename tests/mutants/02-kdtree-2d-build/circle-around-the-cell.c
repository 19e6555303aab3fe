// mutant: a circle around the cell is asked
// task: circle_overlaps_box
// caught by: overlap-inside
// says: around the cell
    const double dx = circle.x - ((double)box.minX + box.maxX) / 2, dy = circle.y - ((double)box.minY + box.maxY) / 2;
    const double half = sqrt(pow((double)box.maxX - box.minX, 2) + pow((double)box.maxY - box.minY, 2)) / 2;
    return sqrt(dx * dx + dy * dy) <= circle.radius + half;
