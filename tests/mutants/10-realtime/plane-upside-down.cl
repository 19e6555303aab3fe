// mutant: direction / way
// task: plane_interval
// caught by: plane-one-way
// says: upside down
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? direction.high / way : INFINITY,
                          direction.low > 0.0f ? direction.low / way : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? direction.low / way : INFINITY,
                      direction.high < 0.0f ? direction.high / way : INFINITY};
