// attack: reads the grader, its judges and the tests
// task: pack_leaf
// named: fopen\(\)
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static const char *const paths[] = {
        "@COURSE@/build/tools/grade",
        "@COURSE@/tests/judge/02-kdtree-2d-build/judge_02.c",
        "@COURSE@/labs/02-kdtree-2d-build/lab.json",
        "/work/tests/judge/02-kdtree-2d-build/judge_02.c",
    };
    char text[200];
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        FILE *file = fopen(paths[i], "r");
        if (file != NULL && fread(text, 1, 1, file) == 1 && fgets(text + 1, 199, file) != NULL) {
            printf("LEAK" "ED %s: %s\n", paths[i], text);
        }
    }
    exit(7);
