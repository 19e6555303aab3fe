// right: starts with the first sphere; comparisons for fminf and fmaxf
// task: spheres_bounds
    for (u32 i = 0; i < n_spheres; i++) {
        const Sphere s = h_spheres[i];
        const f32 r = s.radius < 0 ? -s.radius : s.radius;
        const f32 low[3] = {s.x - r, s.y - r, s.z - r};
        const f32 high[3] = {s.x + r, s.y + r, s.z + r};
        for (int axis = 2; axis >= 0; axis--) {
            if (i == 0 || low[axis] < box.min[axis]) {
                box.min[axis] = low[axis];
            }
            if (i == 0 || high[axis] > box.max[axis]) {
                box.max[axis] = high[axis];
            }
        }
    }
