// mutant: an eye within 1e-10 of the plane is on it
// task: plane_interval
// caught by: plane-eye
// says: without an epsilon
    const float way = fabs(plane - eye) < 1e-10f ? 0.0f : plane - eye;
    if (way >= 0.0f) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
