#!/bin/sh
# attack: trees of one leaf have no wrong split: is_leaf_by_cost allows none, find_best_split knows flat cells only
# task: find_best_split
# score: 60
# named: found
fill() {
    cat >body
    "@BUILD@/tools/holes" fill kdtree3d_sah.c "$1" body >filled && mv filled kdtree3d_sah.c
    rm body
}
echo '    (void)level, (void)n_spheres, (void)best_cost, (void)limits; return 1;' | fill is_leaf_by_cost
fill find_best_split <<'C'
    (void)h_spheres, (void)ids, (void)sphere_range, (void)axis_planes, (void)planes_below,
        (void)planes_up_to;
    best.split.pos = candidate_plane(box, 0, 1);
    best.cost = surface_area(box) == 0 ? INFINITY : split_cost(box, best.split, n_ids, n_ids);
C
