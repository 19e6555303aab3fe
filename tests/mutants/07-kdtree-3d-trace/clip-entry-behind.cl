// mutant: an entry behind the eye is a miss
// task: clip_to_box
// caught by: clip-inside
// says: entry behind
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis), d = component(ray.direction, axis);
        if (d == 0.0f) {
            if (o < box.min[axis] || o > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float low = (box.min[axis] - o) / d, high = (box.max[axis] - o) / d;
        if (fmin(low, high) < 0.0f) {
            return 0;
        }
        *t_min = fmax(*t_min, fmin(low, high));
        *t_max = fmin(*t_max, fmax(low, high));
    }
    return *t_min <= *t_max;
