// mutant: the box starts from zeros and so always holds the origin
// task: spheres_bounds
// caught by: bounds-positive
// says: origin
    if (n_spheres == 0) {
        return box;
    }
    for (u32 i = 0; i < n_spheres; i++) {
        const f32 centre[3] = {h_spheres[i].x, h_spheres[i].y, h_spheres[i].z};
        const f32 radius = fabsf(h_spheres[i].radius);
        for (int axis = 0; axis < 3; axis++) {
            box.min[axis] = fminf(box.min[axis], centre[axis] - radius);
            box.max[axis] = fmaxf(box.max[axis], centre[axis] + radius);
        }
    }
