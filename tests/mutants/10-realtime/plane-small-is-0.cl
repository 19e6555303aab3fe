// mutant: a direction below 1e-4 counts as 0
// task: plane_interval
// caught by: plane-both-ways
// says: without an epsilon
    const float way = plane - eye;
    const float low = fabs(direction.low) < 1e-4f ? 0.0f : direction.low;
    const float high = fabs(direction.high) < 1e-4f ? 0.0f : direction.high;
    if (eye <= plane) {
        return (Interval){high > 0.0f ? way / high : INFINITY,
                          low > 0.0f ? way / low : INFINITY};
    }
    return (Interval){low < 0.0f ? way / low : INFINITY,
                      high < 0.0f ? way / high : INFINITY};
