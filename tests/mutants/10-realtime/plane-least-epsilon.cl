// mutant: directions below 1e-37 count as along the plane
// task: plane_interval
// caught by: plane-one-way
// says: without an epsilon
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 1e-37f ? way / direction.high : INFINITY,
                          direction.low > 1e-37f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < -1e-37f ? way / direction.low : INFINITY,
                      direction.high < -1e-37f ? way / direction.high : INFINITY};
