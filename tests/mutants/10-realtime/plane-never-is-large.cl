// mutant: a large number for what is never met
// task: plane_interval
// caught by: plane-one-way
// says: not at a large number
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : 1e30f,
                          direction.low > 0.0f ? way / direction.low : 1e30f};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : 1e30f,
                      direction.high < 0.0f ? way / direction.high : 1e30f};
