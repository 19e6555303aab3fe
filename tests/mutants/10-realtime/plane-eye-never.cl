// mutant: an eye on the plane: nobody meets it
// task: plane_interval
// caught by: plane-eye
// says: at 0, and others never
    if (eye == plane) {
        return (Interval){INFINITY, INFINITY};
    }
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
