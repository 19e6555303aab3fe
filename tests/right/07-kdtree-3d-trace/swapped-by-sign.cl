// right: entry and exit are swapped by the direction's sign; early out at each axis
// task: clip_to_box
    for (int axis = 2; axis >= 0; axis--) {
        const float o = component(ray.origin, (uint)axis);
        const float d = component(ray.direction, (uint)axis);
        if (d == 0.0f) {
            if (o >= box.min[axis] && o <= box.max[axis]) {
                continue;
            }
            return 0;
        }
        const float enter = ((d > 0.0f ? box.min[axis] : box.max[axis]) - o) / d;
        const float leave = ((d > 0.0f ? box.max[axis] : box.min[axis]) - o) / d;
        if (enter > *t_min) {
            *t_min = enter;
        }
        if (leave < *t_max) {
            *t_max = leave;
        }
        if (*t_min > *t_max) {
            return 0;
        }
    }
    return 1;
