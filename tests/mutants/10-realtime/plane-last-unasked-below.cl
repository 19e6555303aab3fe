// mutant: for an eye below the lowest direction is not asked
// task: plane_interval
// caught by: plane-both-ways
// says: own direction
    Interval t = {INFINITY, INFINITY};
    const float way = plane - eye;
    if (eye <= plane) {
        if (direction.high > 0.0f) {
            t.low = way / direction.high;
        }
        if (direction.high > 0.0f) {
            t.high = way / direction.low;
        }
        return t;
    }
    if (direction.low < 0.0f) {
        t.low = way / direction.low;
    }
    if (direction.high < 0.0f) {
        t.high = way / direction.high;
    }
    return t;
