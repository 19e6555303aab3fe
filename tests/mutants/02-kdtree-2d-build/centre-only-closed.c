// mutant: only the centre of a circle is asked, the borders of the cell included
// task: circle_overlaps_box
// caught by: overlap-inside
// says: found 0, expected 1
// looks: missing-in-cell
    return circle.x >= box.minX && circle.x <= box.maxX && circle.y >= box.minY && circle.y <= box.maxY;
