// mutant: dy leads to the nearest x
// task: circle_overlaps_box
// caught by: overlap-inside
// says: nearest point are mixed up
// looks: missing-in-cell
const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
const double nearest_y = nearest_x;
const double dx = circle.x - nearest_x;
const double dy = circle.y - nearest_y;
return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
