// mutant: t_min and t_max stay as they came
// task: clip_to_box
// caught by: clip-through
// says: not stored
    float enter = *t_min, leave = *t_max;
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis), d = component(ray.direction, axis);
        if (d == 0.0f) {
            if (o < box.min[axis] || o > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float low = (box.min[axis] - o) / d, high = (box.max[axis] - o) / d;
        enter = fmax(enter, fmin(low, high));
        leave = fmin(leave, fmax(low, high));
    }
    return enter <= leave;
