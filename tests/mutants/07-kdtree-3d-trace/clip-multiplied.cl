// mutant: multiplied with the direction
// task: clip_to_box
// caught by: clip-through
// says: multiplied
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis);
        const float d = component(ray.direction, axis);
        if (d == 0.0f) {
            if (o < box.min[axis] || o > box.max[axis]) {
                return 0;
            }
            continue;
        }
        const float t0 = (box.min[axis] - o) * d;
        const float t1 = (box.max[axis] - o) * d;
        *t_min = fmax(*t_min, fmin(t0, t1));
        *t_max = fmin(*t_max, fmax(t0, t1));
    }
    return *t_min <= *t_max;
