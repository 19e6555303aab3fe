// mutant: only the first ray is asked whether it meets the plane
// task: plane_interval
// caught by: plane-both-ways
// says: only the first ray
    const float way = plane - eye;
    if (eye <= plane) {
        if (direction.high <= 0.0f) {
            return (Interval){INFINITY, INFINITY};
        }
        return (Interval){way / direction.high, way / direction.low};
    }
    if (direction.low >= 0.0f) {
        return (Interval){INFINITY, INFINITY};
    }
    return (Interval){way / direction.low, way / direction.high};
