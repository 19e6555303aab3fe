// mutant: both ends are sorted, negative ones, too
// task: plane_interval
// caught by: plane-both-ways
// says: never meet it
    const float a = (plane - eye) / direction.low;
    const float b = (plane - eye) / direction.high;
    return (Interval){fmin(a, b), fmax(a, b)};
