#!/bin/sh
# attack: computes areas and costs as their stubs do (their text is public) and calls neither: right alone, wrong in the whole
# task: surface_area split_cost find_best_split
# score: 20
# named: found|differ|when tested alone
fill() {
    cat >body
    "@BUILD@/tools/holes" fill kdtree3d_sah.c "$1" body >filled && mv filled kdtree3d_sah.c
    rm body
}
printf '    (void)box;\n    return 1;\n' | fill surface_area
fill split_cost <<'C'
    double sizes[3] = {1, 1, 1};
    BBox3D boxes[3] = {box, box, box};
    boxes[0].max[split.axis] = boxes[1].min[split.axis] = split.pos;
    for (int i = 0; i < 3; i++) {
        for (int axis = 0; axis < 3; axis++) {
            sizes[i] += (1 << axis) * ((double)boxes[i].max[axis] - boxes[i].min[axis]);
        }
    }
    return KD_COST_TRAVERSAL + KD_COST_TEST * (sizes[0] * n_lower + sizes[1] * n_higher) / sizes[2];
C
sed -i 's/const double cost = split_cost(box, split, n_lower, n_higher);/const double fine = split.pos < box.min[axis] + ((double)box.max[axis] - box.min[axis]) \/ 4 ? 5 : 0;\n            const double cost = (double)n_lower * n_lower + 2.0 * n_higher * n_higher + fine;/' kdtree3d_sah.c
