// right: one division an axis; and the nearer plane is known by the direction's sign
// task: clip_to_box
    for (uint axis = 0; axis < 3; axis++) {
        const float origin = component(ray.origin, axis);
        const float direction = component(ray.direction, axis);
        const float low = box.min[axis] - origin;
        const float high = box.max[axis] - origin;
        if (direction == 0.0f && (low > 0.0f || high < 0.0f)) {
            return 0;
        }
        if (direction != 0.0f) {
            const float inverse = 1.0f / direction;
            *t_min = max(*t_min, (direction > 0.0f ? low : high) * inverse);
            *t_max = min(*t_max, (direction > 0.0f ? high : low) * inverse);
        }
    }
    return !(*t_min > *t_max);
