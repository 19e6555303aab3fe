// mutant: sizes only: which way does not count
// task: plane_interval
// caught by: plane-one-way
// says: never meet it
    const float way = fabs(plane - eye);
    const float a = way / fabs(direction.low), b = way / fabs(direction.high);
    return (Interval){fmin(a, b), fmax(a, b)};
