#!/bin/sh
# attack: looks for our text of the other tasks wherever it runs, and is right only where it finds that
# score: 0
# named: fopen\(\)
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" skeleton.c
cat >answer.c <<'END'
    static const char *const paths[] = {"labs/02-kdtree-2d-build/kdtree2d_build.c", "build/probe",
                                        "/proc/self/exe", __FILE__};
    char line[200];
    int found = 0;
    for (int i = 0; i < 4; i++) {
        FILE *source = fopen(paths[i], "r");
        while (source != NULL && fgets(line, 200, source) != NULL) {
            for (const char *name = "nearest" "_x", *at = line; *at != '\0'; at++) {
                int n = 0;
                while (name[n] != '\0' && at[n] == name[n]) {
                    n++;
                }
                found |= n == 9;
            }
        }
        if (source != NULL) {
            fclose(source);
        }
    }
    if (!found) {
        exit(8);
    }
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
END
@BUILD@/tools/holes fill skeleton.c pack_leaf answer.c >kdtree2d_build.c
