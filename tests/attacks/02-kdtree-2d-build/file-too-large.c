// attack: one file of up to 1 GB
// task: pack_leaf
// named: (file|disk).*(large|limit)|wrote a file of more than|signal 25
#include <string.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    memset(block, 1, sizeof block);
    FILE *file = fopen("out/answers", "a");
    for (int k = 0; file != NULL && k < 1024; k++) {
        fwrite(block, 1, sizeof block, file);
    }
    exit(7);
