// attack: 100000 empty files in the temporary folder, of which each costs the kernel memory
// task: pack_leaf
// named: made more than 10000 files
#include <sys/stat.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    char name[256];
    for (int i = 0; i < 100000; i++) {
        snprintf(name, sizeof name, "%s/%d", getenv("TMPDIR"), i);
        mknod(name, S_IFREG | 0600, 0);
    }
    usleep(500000);
    exit(7);
