// mutant: the ends for an eye below, whichever side it is on
// task: plane_interval
// caught by: plane-one-way
// says: below the plane only
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.high < 0.0f ? way / direction.high : INFINITY,
                      direction.low < 0.0f ? way / direction.low : INFINITY};
