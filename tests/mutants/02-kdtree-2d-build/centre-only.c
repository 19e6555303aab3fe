// mutant: a circle counts only where its centre lies in the cell
// task: circle_overlaps_box
// caught by: overlap-inside
// says: found 0, expected 1
// looks: missing-in-cell
    return circle.x >= box.minX && circle.x <= box.maxX && circle.y >= box.minY &&
           circle.y <= box.maxY;
