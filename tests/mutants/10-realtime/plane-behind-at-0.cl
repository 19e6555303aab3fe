// mutant: what goes away meets the plane at 0
// task: plane_interval
// caught by: plane-one-way
// says: as if they met it at the eye
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : 0.0f,
                          direction.low > 0.0f ? way / direction.low : 0.0f};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : 0.0f,
                      direction.high < 0.0f ? way / direction.high : 0.0f};
