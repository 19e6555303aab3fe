// mutant: an eye on the plane gives 0 to INFINITY
// task: plane_interval
// caught by: plane-eye
// says: rays that go up meet it
    if (eye == plane) {
        return (Interval){0.0f, INFINITY};
    }
    const int is_below = eye <= plane;
    const float way = plane - eye;
    const float fastest = is_below ? direction.high : direction.low;
    const float slowest = is_below ? direction.low : direction.high;
    Interval t = {INFINITY, INFINITY};
    if (is_below ? fastest > 0.0f : fastest < 0.0f) {
        t.low = way / fastest;
    }
    if (is_below ? slowest > 0.0f : slowest < 0.0f) {
        t.high = way / slowest;
    }
    return t;
