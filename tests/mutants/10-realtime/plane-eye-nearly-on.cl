// mutant: an eye a hair above the plane counts as on it
// task: plane_interval
// caught by: plane-eye
// says: beside the plane
    const float way = plane - eye;
    if (eye <= plane + 1e-5f) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
