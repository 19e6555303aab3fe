// attack: writes answers of its own, every section and the end, and ends with status 0
// task: pack_leaf
// named: fopen\(\)
    (void)tree, (void)id, (void)ids, (void)n_ids;
    extern void _exit(int);
    static const char *const names[] = {"leaves", "splits", "overlaps", "distribute",
                                        "pack",   "tree.0", "tree.1",   "end"};
    FILE *answers = fopen("out/answers", "w");
    for (int i = 0; answers != NULL && i < 8; i++) {
        char section[32 + 4096] = {0};
        snprintf(section, 24, "%s", names[i]);
        section[24 + 1] = i < 7 ? 16 : 0;  // 4096 bytes, in the machine's order
        fwrite(section, 1, i < 7 ? sizeof section : 32, answers);
    }
    fflush(answers);
    _exit(0);
