// attack: 1 GB on standard output
// task: pack_leaf
// named: exit status 7|output
#include <string.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    memset(block, 'x', sizeof block);
    for (int i = 0; i < 1024; i++) {
        fwrite(block, 1, sizeof block, stdout);
    }
    exit(7);
