// right: the three axes written out with vectors; an axis along the planes by itself
// task: clip_to_box
    const float3 low = (float3)(box.min[0], box.min[1], box.min[2]);
    const float3 high = (float3)(box.max[0], box.max[1], box.max[2]);
    const int3 along = ray.direction == 0.0f;
    if (any(along & ((ray.origin < low) | (ray.origin > high)))) {
        return 0;
    }
    const float3 to_low = (low - ray.origin) / ray.direction;
    const float3 to_high = (high - ray.origin) / ray.direction;
    const float3 enter = select(fmin(to_low, to_high), (float3)(-INFINITY), along);
    const float3 leave = select(fmax(to_low, to_high), (float3)(INFINITY), along);
    *t_min = fmax(*t_min, fmax(enter.x, fmax(enter.y, enter.z)));
    *t_max = fmin(*t_max, fmin(leave.x, fmin(leave.y, leave.z)));
    return *t_min <= *t_max;
