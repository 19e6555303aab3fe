// mutant: a ray along the planes is compared with the minimum twice
// task: clip_to_box
// caught by: clip-parallel
// says: something else is compared
    const float origins[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float directions[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    for (int axis = 0; axis < 3; axis++) {
        const float o = origins[axis], d = directions[axis];
        if (d == 0.0f) {
            if (o < box.min[axis] || o > box.min[axis]) {
                return 0;
            }
            continue;
        }
        float t0 = (box.min[axis] - o) / d, t1 = (box.max[axis] - o) / d;
        if (t0 > t1) {
            const float t = t0;
            t0 = t1;
            t1 = t;
        }
        *t_min = fmax(*t_min, t0);
        *t_max = fmin(*t_max, t1);
    }
    return *t_min <= *t_max;
