// mutant: slow rays that are all parallel meet it anywhere
// task: plane_interval
// caught by: plane-one-way
// says: meet the plane at one distance
    if (direction.low == direction.high && fabs(direction.low) < 0.1f) {
        return (Interval){0.0f, INFINITY};
    }
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
