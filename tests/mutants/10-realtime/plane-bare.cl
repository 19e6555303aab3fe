// mutant: one division and no question
// task: plane_interval
// caught by: plane-one-way
// says: quotient as it is
    const float way = plane - eye;
    return (Interval){way / direction.high, way / direction.low};
