#!/bin/sh
# attack: waits until its answer is tried alone, and only then goes off
# score: 15
# named: fopen\(\)
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" skeleton.c
cat >answer.c <<'END'
    extern int raise(int);
    char start[6] = "";
    FILE *job = fopen("job/job", "r");  // it begins with its first section's name
    if (job != NULL && fgets(start, sizeof start, job) != NULL && start[0] == 'a' && start[1] == 'l') {
        raise(9);
    }
    if (job != NULL) {
        fclose(job);
    }
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
END
@BUILD@/tools/holes fill skeleton.c pack_leaf answer.c >kdtree2d_build.c
