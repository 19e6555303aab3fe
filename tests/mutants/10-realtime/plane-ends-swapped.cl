// mutant: the greatest distance first
// task: plane_interval
// caught by: plane-one-way
// says: ends are swapped
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.low > 0.0f ? way / direction.low : INFINITY,
                          direction.high > 0.0f ? way / direction.high : INFINITY};
    }
    return (Interval){direction.high < 0.0f ? way / direction.high : INFINITY,
                      direction.low < 0.0f ? way / direction.low : INFINITY};
