// mutant: one division and no question, the lowest first
// task: plane_interval
// caught by: plane-both-ways
// says: quotient as it is
    const float way = plane - eye;
    return (Interval){way / direction.low, way / direction.high};
