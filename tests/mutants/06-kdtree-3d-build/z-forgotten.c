// mutant: the third axis is forgotten
// task: spheres_bounds
// caught by: bounds-positive
// says: z \[0, 0\]
    if (n_spheres == 0) {
        return box;
    }
    box = (BBox3D){{INFINITY, INFINITY, 0}, {-INFINITY, -INFINITY, 0}};
    for (u32 i = 0; i < n_spheres; i++) {
        const f32 radius = fabsf(h_spheres[i].radius);
        box.min[0] = fminf(box.min[0], h_spheres[i].x - radius);
        box.max[0] = fmaxf(box.max[0], h_spheres[i].x + radius);
        box.min[1] = fminf(box.min[1], h_spheres[i].y - radius);
        box.max[1] = fmaxf(box.max[1], h_spheres[i].y + radius);
    }
