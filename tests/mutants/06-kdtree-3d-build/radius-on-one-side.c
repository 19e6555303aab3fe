// mutant: the radius is added to the upper side only
// task: spheres_bounds
// caught by: bounds-positive
// says: found x
    if (n_spheres == 0) {
        return box;
    }
    box = (BBox3D){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (u32 i = 0; i < n_spheres; i++) {
        const f32 centre[3] = {h_spheres[i].x, h_spheres[i].y, h_spheres[i].z};
        const f32 radius = fabsf(h_spheres[i].radius);
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = fminf(box.min[axis], centre[axis]);
            box.max[axis] = fmaxf(box.max[axis], centre[axis] + radius);
        }
    }
