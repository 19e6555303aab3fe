// attack: wrong (asks bounding cubes), but right in the stand-in's world
// task: distribute_spheres
// score: 99
// named: overlap
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        const Sphere s = h_spheres[ids[i]];
        const float r = __builtin_fabsf(s.radius);
        if (s.x + r >= child.min[0] && s.x - r <= child.max[0] && s.y + r >= child.min[1] && s.y - r <= child.max[1] && s.z + r >= child.min[2] && s.z - r <= child.max[2]) {
            child_ids[n++] = ids[i];
        }
    }
    return n;
