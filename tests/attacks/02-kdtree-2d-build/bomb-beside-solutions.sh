#!/bin/sh
# attack: waits until it runs beside our solution of the other tasks, and only then goes off
# score: 15
# named: signal 9|exit status|crashed
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" skeleton.c
cat >answer.c <<'END'
    extern int raise(int);
    if (tree->n_nodes > 40) {  // the skeleton's other functions never split
        raise(9);
    }
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
END
@BUILD@/tools/holes fill skeleton.c pack_leaf answer.c >kdtree2d_build.c
