// mutant: only the lower borders are compared
// task: circle_overlaps_box
// caught by: overlap-inside
// says: one border of each axis alone
    return circle.x + circle.radius >= box.minX && circle.y + circle.radius >= box.minY;
