// mutant: an eye on the plane counts to the upper side
// task: plane_interval
// caught by: plane-eye
// says: counts to the lower side
    const float way = plane - eye;
    if (eye < plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
