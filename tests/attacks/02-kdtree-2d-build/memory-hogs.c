// attack: eight processes that hold 512 MB each
// task: pack_leaf
// named: fork\(\)|memory
// limit: 2
#include <string.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 7; i++) {
        if (fork() == 0) {
            break;
        }
    }
    char *bytes = malloc(512 << 20);
    if (bytes != NULL) {
        memset(bytes, 1, 512 << 20);
    }
    sleep(20);
    exit(7);
