// mutant: the least distance twice
// task: plane_interval
// caught by: plane-one-way
// says: both ends are the least
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.high > 0.0f ? way / direction.high : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.low < 0.0f ? way / direction.low : INFINITY};
