// mutant: the cell's corners, the centre and the circle's four tips are asked
// task: circle_overlaps_box
// caught by: overlap-inside
// says: tips
    const double x = circle.x, y = circle.y, r = circle.radius;
    const double points[][2] = {{x, y}, {x - r, y}, {x + r, y}, {x, y - r}, {x, y + r}};
    for (int i = 0; i < 5; i++) {
        if (points[i][0] >= box.minX && points[i][0] <= box.maxX && points[i][1] >= box.minY &&
            points[i][1] <= box.maxY) {
            return 1;
        }
    }
    for (int i = 0; i < 4; i++) {
        const double dx = x - (i % 2 ? box.minX : box.maxX);
        const double dy = y - (i / 2 ? box.minY : box.maxY);
        if (dx * dx + dy * dy <= r * r) {
            return 1;
        }
    }
    return 0;
