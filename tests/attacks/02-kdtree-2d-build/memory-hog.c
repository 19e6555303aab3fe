// attack: fills the memory, 5 GB at most
// task: pack_leaf
// named: memory
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 80; i++) {
        char *bytes = malloc(64 << 20);
        if (bytes == NULL) {
            break;
        }
        for (int page = 0; page < 64 << 20; page += 4096) {
            bytes[page] = 1;
        }
    }
    abort();
