// attack: takes all memory, 5 GB at most (memory-hogs also fills what it takes)
// task: pack_leaf
// named: memory|the program ended itself: abort
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 80; i++) {
        char *bytes = malloc(64 << 20);
        if (bytes == NULL) {
            break;
        }
        bytes[0] = 1;
    }
    abort();
