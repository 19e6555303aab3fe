// mutant: the side of the eye is inverted
// task: plane_interval
// caught by: plane-one-way
// says: side is inverted
    Interval t = {INFINITY, INFINITY};
    const float way = plane - eye;
    if (plane < eye) {
        if (direction.high > 0.0f) {
            t.low = way / direction.high;
        }
        if (direction.low > 0.0f) {
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
