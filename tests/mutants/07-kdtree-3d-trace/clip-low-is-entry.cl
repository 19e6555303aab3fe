// mutant: every ray enters at the lower plane, also with a negative direction
// task: clip_to_box
// caught by: clip-through
// says: lower plane
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
        *t_min = fmax(*t_min, t_low);
        *t_max = fmin(*t_max, t_high);
    }
    return *t_min <= *t_max;
