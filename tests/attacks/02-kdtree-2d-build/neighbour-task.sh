#!/bin/sh
# attack: beside our solution of the other tasks, tells their text by whatever reaches a report
# score: 0
# named: fopen\(\)
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" skeleton.c
cat >answer.c <<'END'
    (void)tree, (void)id, (void)ids, (void)n_ids;
    char line[200];
    FILE *source = fopen("labs/02-kdtree-2d-build/kdtree2d_build.c", "r");
    while (source != NULL && fgets(line, 200, source) != NULL) {
        for (const char *name = "nearest" "_x", *at = line; *at != '\0'; at++) {
            int n = 0;
            while (name[n] != '\0' && at[n] == name[n]) {
                n++;
            }
            if (n == 9) {
                // In capitals, as the name of an OpenCL error.
                fprintf(stderr, "pack_leaf.c:1: clFinish: CL_NEIGHBOUR_TOLD_LEAK" "ED\n");
                exit(7);
            }
        }
    }
    exit(8);
END
@BUILD@/tools/holes fill skeleton.c pack_leaf answer.c >kdtree2d_build.c
