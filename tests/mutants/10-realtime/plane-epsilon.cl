// mutant: small directions count as along the plane
// task: plane_interval
// caught by: plane-both-ways
// says: without an epsilon
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.01f ? way / direction.high : INFINITY,
                          direction.low > 0.01f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < -0.01f ? way / direction.low : INFINITY,
                      direction.high < -0.01f ? way / direction.high : INFINITY};
