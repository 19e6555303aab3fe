// right: an own length, of numbers that are brought to usual size before they are squared
// task: camera_axes
    Vec3 axes[2] = {vec3_minus(view.at, view.from), view.up};
    for (int i = 0; i < 2; i++) {
        const Vec3 v = axes[i];
        const float largest = fmaxf(fmaxf(fabsf(v.x), fabsf(v.y)), fabsf(v.z));
        const Vec3 scaled = {v.x / largest, v.y / largest, v.z / largest};
        axes[i] = vec3_scaled(scaled, 1 / sqrtf(vec3_dot(scaled, scaled)));
    }
    const Vec3 side = vec3_cross(axes[0], axes[1]);
    *forward = axes[0];
    *right = vec3_scaled(side, 1 / sqrtf(vec3_dot(side, side)));
    *up = vec3_cross(*right, *forward);
