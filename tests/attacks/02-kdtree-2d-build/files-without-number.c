// attack: 12 000 empty files beside the answers
// task: pack_leaf
// named: fopen\(\)|files
    (void)tree, (void)id, (void)ids, (void)n_ids;
    char path[64];
    for (int i = 0; i < 12000; i++) {
        snprintf(path, sizeof path, "out/%d", i);
        FILE *file = fopen(path, "w");
        if (file == NULL) {
            break;
        }
        fclose(file);
    }
    exit(7);
