// attack: fills the memory, 5 GB at most
// task: pack_leaf
// named: memory
#include <string.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 80; i++) {
        char *bytes = malloc(64 << 20);
        if (bytes == NULL) {
            break;
        }
        memset(bytes, i + 1, 64 << 20);
    }
    abort();
