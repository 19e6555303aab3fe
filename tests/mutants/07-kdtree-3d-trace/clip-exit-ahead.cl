// mutant: only the exit is asked: is it ahead?
// task: clip_to_box
// caught by: clip-through
// says: exit is ahead
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis), d = component(ray.direction, axis);
        if (d == 0.0f) {
            if (o < box.min[axis] || o > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float low = (box.min[axis] - o) / d, high = (box.max[axis] - o) / d;
        *t_min = fmax(*t_min, fmin(low, high));
        *t_max = fmin(*t_max, fmax(low, high));
    }
    return *t_max >= 0.0f;
