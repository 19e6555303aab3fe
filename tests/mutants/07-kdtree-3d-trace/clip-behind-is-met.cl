// mutant: the exits come after the entries: that they may be behind the eye is not asked
// task: clip_to_box
// caught by: clip-behind
// says: expected 0
    float entry = -INFINITY, leave = INFINITY;
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
        entry = fmax(entry, fmin(t_low, t_high));
        leave = fmin(leave, fmax(t_low, t_high));
    }
    *t_min = fmax(*t_min, entry);
    *t_max = fmin(*t_max, leave);
    return entry <= leave;
