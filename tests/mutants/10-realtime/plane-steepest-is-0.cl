// mutant: a small steepest direction counts as along the plane
// task: plane_interval
// caught by: plane-one-way
// says: no small number is 0
    const int is_below = eye <= plane;
    const float way = plane - eye;
    const float fastest = is_below ? direction.high : direction.low;
    const float slowest = is_below ? direction.low : direction.high;
    Interval t = {INFINITY, INFINITY};
    if (is_below ? fastest > 1e-6f : fastest < -1e-6f) {
        t.low = way / fastest;
    }
    if (is_below ? slowest > 0.0f : slowest < 0.0f) {
        t.high = way / slowest;
    }
    return t;
