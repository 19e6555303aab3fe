#!/bin/sh
# attack: every leaf is packed into node 0, so that the tree is one leaf: no split of it is wrong, and
# it is not too deep, though choose_split halves nothing and fits_todo allows all
# score: 42
# named: found 0 nodes with children
fill() {
    @BUILD@/tools/holes fill kdtree3d_build.c "$1" answer >filled
    mv filled kdtree3d_build.c
}
cat >answer <<'END'
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[split.axis] - box.min[split.axis]) {
            split.axis = axis;
        }
    }
    split.pos = box.min[split.axis] + (box.max[split.axis] - box.min[split.axis]) / 3;
END
fill choose_split
cat >answer <<'END'
    (void)id;
    tree->nodes[0] = (KdNode3){0, KD_LEAF, tree->n_sphere_ids, n_ids};
    for (u32 i = 0; i < n_ids; i++) {
        tree->sphere_ids[tree->n_sphere_ids++] = ids[i];
    }
END
fill pack_leaf_range
echo '    return level > 0;' >answer
fill fits_todo
rm answer
