// attack: 2000 folders, one inside the other, longer than any path may be, the last one locked
// task: pack_leaf
// named: mkdir\(\)
#include <sys/stat.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static const char name[] = "a-folder-in-a-folder-in-a-folder";
    (void)!chdir("out");
    for (int i = 0; i < 2000; i++) {
        if (mkdir(name, 0777) != 0 || chdir(name) != 0) {
            break;
        }
    }
    mkdir("locked", 0);
    chmod("/work/out", 0);
    exit(7);
