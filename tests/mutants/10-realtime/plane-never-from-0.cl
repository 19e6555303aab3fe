// mutant: the least distance of rays that go away is 0
// task: plane_interval
// caught by: plane-one-way
// says: not the greatest distance alone
    const int is_below = eye <= plane;
    const float way = plane - eye;
    const float fastest = is_below ? direction.high : direction.low;
    const float slowest = is_below ? direction.low : direction.high;
    Interval t = {0.0f, INFINITY};
    if (is_below ? fastest > 0.0f : fastest < 0.0f) {
        t.low = way / fastest;
    }
    if (is_below ? slowest > 0.0f : slowest < 0.0f) {
        t.high = way / slowest;
    }
    return t;
