// mutant: the part that is handed in does not count: neither t_min nor t_max
// task: clip_to_box
// caught by: clip-inside
// says: neither t_min nor t_max
    *t_min = -INFINITY;
    *t_max = INFINITY;
    for (uint axis = 0; axis < 3; axis++) {
        const float origin = component(ray.origin, axis);
        const float direction = component(ray.direction, axis);
        if (direction == 0.0f) {
            if (origin < box.min[axis] || origin > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float t_low = (box.min[axis] - origin) / direction;
        const float t_high = (box.max[axis] - origin) / direction;
        *t_min = fmax(*t_min, fmin(t_low, t_high));
        *t_max = fmin(*t_max, fmax(t_low, t_high));
    }
    return *t_min <= *t_max;
