// mutant: z is forgotten
// task: clip_to_box
// caught by: clip-through
// says: not all of the three axes
    for (uint axis = 0; axis < 2; axis++) {
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
