// right: one over the direction first
// task: plane_interval
    const float sign = eye <= plane ? 1.0f : -1.0f;
    const float steepest = sign > 0.0f ? direction.high : -direction.low;
    const float flattest = sign > 0.0f ? direction.low : -direction.high;
    const float way = sign * (plane - eye);
    Interval interval = {INFINITY, INFINITY};
    if (steepest > 0.0f) {
        interval.low = way * (1.0f / steepest);
    }
    if (flattest > 0.0f) {
        interval.high = way * (1.0f / flattest);
    }
    return interval;
