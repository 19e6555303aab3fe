// mutant: what goes away meets the plane behind the eye
// task: plane_interval
// caught by: plane-one-way
// says: never meet it
    const float way = plane - eye;
    if (eye <= plane) {
        return (Interval){way / direction.high, way / direction.low};
    }
    return (Interval){way / direction.low, way / direction.high};
