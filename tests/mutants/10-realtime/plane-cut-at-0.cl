// mutant: both ends are sorted, and not below 0
// task: plane_interval
// caught by: plane-both-ways
// says: met it at the eye
    const float a = (plane - eye) / direction.low;
    const float b = (plane - eye) / direction.high;
    if (a < 0.0f && b < 0.0f) {
        return (Interval){INFINITY, INFINITY};
    }
    return (Interval){fmax(0.0f, fmin(a, b)), fmax(a, b)};
