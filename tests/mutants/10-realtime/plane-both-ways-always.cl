// mutant: rays of both signs: anywhere
// task: plane_interval
// caught by: plane-both-ways
// says: wider than it
    if (direction.low < 0.0f && direction.high > 0.0f) {
        return (Interval){0.0f, INFINITY};
    }
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
