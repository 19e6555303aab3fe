// mutant: an axis that the ray goes along decides alone
// task: clip_to_box
// caught by: clip-parallel
// says: decided for the whole box
    for (uint axis = 0; axis < 3; axis++) {
        const float o = component(ray.origin, axis), d = component(ray.direction, axis);
        if (d == 0.0f) {
            return box.min[axis] <= o && o <= box.max[axis];
        }
        const float low = (box.min[axis] - o) / d, high = (box.max[axis] - o) / d;
        *t_min = fmax(*t_min, fmin(low, high));
        *t_max = fmin(*t_max, fmax(low, high));
    }
    return *t_min <= *t_max;
