// mutant: the eye is forgotten
// task: plane_interval
// caught by: plane-one-way
// says: without the eye
    const float way = plane;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
