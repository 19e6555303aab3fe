// mutant: what is never met is at -INFINITY
// task: plane_interval
// caught by: plane-one-way
// says: not at -INFINITY
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : -INFINITY,
                          direction.low > 0.0f ? way / direction.low : -INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : -INFINITY,
                      direction.high < 0.0f ? way / direction.high : -INFINITY};
