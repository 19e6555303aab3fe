// mutant: the circle's bounding square is tested instead of the circle
// task: circle_overlaps_box
// caught by: overlap-corner
// says: bounding square
    return circle.x + circle.radius >= box.minX && circle.x - circle.radius <= box.maxX &&
           circle.y + circle.radius >= box.minY && circle.y - circle.radius <= box.maxY;
