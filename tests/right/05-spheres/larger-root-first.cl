// right: the leaving root first: without it there is no hit
// task: nearest_root
    if (disc < 0.0f || b + sqrt(disc) <= t_min) {
        return INFINITY;
    }
    const float far = b + sqrt(disc);
    const float near = b - sqrt(disc);
    return radius > 0.0f && near > t_min ? near : far;
