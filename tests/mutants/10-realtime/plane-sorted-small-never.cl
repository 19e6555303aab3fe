// mutant: the lesser quotient first, but where directions are small
// task: plane_interval
// caught by: plane-one-way
// says: without an epsilon
    const float way = plane - eye;
    const float low = fabs(direction.low) < 1e-6f ? INFINITY : way / direction.low;
    const float high = fabs(direction.high) < 1e-6f ? INFINITY : way / direction.high;
    return (Interval){fmin(low, high), fmax(low, high)};
