// mutant: a distance of 1
// task: plane_interval
// caught by: plane-one-way
// says: found
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? 1.0f / direction.high : INFINITY,
                          direction.low > 0.0f ? 1.0f / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? 1.0f / direction.low : INFINITY,
                      direction.high < 0.0f ? 1.0f / direction.high : INFINITY};
