// right: cases: beside, above, in a corner or inside
// task: circle_overlaps_box
    const double radius = circle.radius;
    const int beside = circle.x < box.minX ? -1 : circle.x > box.maxX;
    const int above = circle.y < box.minY ? -1 : circle.y > box.maxY;
    if (beside == 0 && above == 0) {
        return 1;
    }
    if (beside == 0) {
        return above < 0 ? circle.y + radius >= box.minY : circle.y - radius <= box.maxY;
    }
    if (above == 0) {
        return beside < 0 ? circle.x + radius >= box.minX : circle.x - radius <= box.maxX;
    }
    const double dx = (double)(beside < 0 ? box.minX : box.maxX) - circle.x;
    const double dy = (double)(above < 0 ? box.minY : box.maxY) - circle.y;
    return !(dx * dx + dy * dy > radius * radius);
