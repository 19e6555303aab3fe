// mutant: plus for minus in dy
// task: circle_overlaps_box
// caught by: overlap-inside
// says: centre plus nearest
// looks: missing-in-cell
const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
const double dx = circle.x - nearest_x;
const double dy = circle.y + nearest_y;
return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
