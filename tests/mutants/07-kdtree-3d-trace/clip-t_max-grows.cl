// mutant: t_max becomes the larger of two
// task: clip_to_box
// caught by: clip-through
// says: t_max grew
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis);
        const float d = component(ray.direction, axis);
        float t0 = (box.min[axis] - o) / d;
        float t1 = (box.max[axis] - o) / d;
        if (d < 0.0f) {
            float swap = t0;
            t0 = t1;
            t1 = swap;
        }
        *t_min = fmax(*t_min, t0);
        *t_max = fmax(*t_max, t1);
    }
    return *t_min <= *t_max;
