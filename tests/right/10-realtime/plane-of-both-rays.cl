// right: each end for itself, then in order
// task: plane_interval
    const int is_lower = eye <= plane;
    float ends[2] = {direction.low, direction.high};
    for (int i = 0; i < 2; i++) {
        const int meets = is_lower ? ends[i] > 0.0f : ends[i] < 0.0f;
        ends[i] = meets ? (plane - eye) / ends[i] : INFINITY;
    }
    return (Interval){fmin(ends[0], ends[1]), fmax(ends[0], ends[1])};
