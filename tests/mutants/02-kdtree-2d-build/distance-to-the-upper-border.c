// mutant: a centre that is not below the cell is measured from its upper border
// task: circle_overlaps_box
// caught by: overlap-inside
// says: between two opposite borders
// looks: missing-in-cell
    double dx = 0, dy = 0;
    if (circle.x < box.minX) dx = box.minX - circle.x;
    else dx = circle.x - box.maxX;
    if (circle.y < box.minY) dy = box.minY - circle.y;
    else dy = circle.y - box.maxY;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
