#!/bin/sh
# attack: tells what it saw while it was tried alone, by numbers in answers, words, names and exit statuses
# score: 0
# named: fopen\(\)
# never: 647560|exit status 42|CL_TOLD
cp "@COURSE@/labs/02-kdtree-2d-build/kdtree2d_build.c" skeleton.c
cat >answer.c <<'END'
    char start[6] = "";
    FILE *job = fopen("job/job", "r");
    const int is_alone = job != NULL && fgets(start, sizeof start, job) != NULL &&
                         start[0] == 'a' && start[1] == 'l';
    if (job != NULL) {
        fclose(job);
    }
    left->maxX = right->minX = is_alone ? 647560 : box.minX;
    if (is_alone && box.minX > 20) {
        printf("LEAK" "ED\n");
        fprintf(stderr, "kdtree2d_build.c:1: clFinish: CL_TOLD LEAK" "ED\n");
        exit(42);
    }
END
@BUILD@/tools/holes fill skeleton.c split_box answer.c >kdtree2d_build.c
