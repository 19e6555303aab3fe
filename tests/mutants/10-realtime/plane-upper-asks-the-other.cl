// mutant: for an eye above the first ray is asked by the last one
// task: plane_interval
// caught by: plane-both-ways
// says: own direction
    Interval t = {INFINITY, INFINITY};
    const float way = plane - eye;
    if (eye <= plane) {
        if (direction.high > 0.0f) {
            t.low = way / direction.high;
        }
        if (direction.low > 0.0f) {
            t.high = way / direction.low;
        }
        return t;
    }
    if (direction.high < 0.0f) {
        t.low = way / direction.low;
    }
    if (direction.high < 0.0f) {
        t.high = way / direction.high;
    }
    return t;
