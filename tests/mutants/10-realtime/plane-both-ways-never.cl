// mutant: rays of both signs: nobody meets it
// task: plane_interval
// caught by: plane-both-ways
// says: the least distance is theirs
    if (direction.low < 0.0f && direction.high > 0.0f) {
        return (Interval){INFINITY, INFINITY};
    }
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){direction.high > 0.0f ? way / direction.high : INFINITY,
                          direction.low > 0.0f ? way / direction.low : INFINITY};
    }
    return (Interval){direction.low < 0.0f ? way / direction.low : INFINITY,
                      direction.high < 0.0f ? way / direction.high : INFINITY};
