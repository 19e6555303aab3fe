// right: recursion: the first half of the ids, then the second behind it
// task: distribute_spheres
    if (n_ids <= 1) {
        if (n_ids == 0 || !sphere_overlaps_box(h_spheres[*ids], child)) {
            return 0;
        }
        *child_ids = *ids;
        return 1;
    }
    const u32 half = n_ids >> 1;
    const u32 n_first = distribute_spheres(h_spheres, ids, half, child, child_ids);
    return n_first +
           distribute_spheres(h_spheres, ids + half, n_ids - half, child, child_ids + n_first);
