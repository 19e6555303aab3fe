// right: one axis after the other, in double
// task: spheres_bounds
    for (int axis = 0; axis < 3; axis++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (u32 i = n_spheres; i-- > 0;) {
            const Sphere s = h_spheres[i];
            const double centre = axis == 0 ? s.x : axis == 1 ? s.y : s.z;
            low = fmin(low, centre - fabs((double)s.radius));
            high = fmax(high, centre + fabs((double)s.radius));
        }
        if (n_spheres > 0) {
            box.min[axis] = (f32)low;
            box.max[axis] = (f32)high;
        }
    }
