// mutant: an eye within 1e-10 of the plane is on it
// task: plane_interval
// caught by: plane-eye
// says: without an epsilon
    const float way = plane - eye;
    if (way >= -1e-10f) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
