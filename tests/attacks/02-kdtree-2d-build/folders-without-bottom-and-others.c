// attack: 300 MB lie deeper than anybody looks, while folders beside them come and go
// task: pack_leaf
// named: folders too deep to look into
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static char block[1 << 20];
    char name[32];
    memset(block, 1, sizeof block);
    (void)!chdir("out");
    if (fork() == 0) {
        for (int i = 0; i < 200000; i++) {
            snprintf(name, sizeof name, "restless-%d", i % 100);
            (void)!(i / 100 % 2 == 0 ? mkdir(name, 0777) : rmdir(name));
        }
        _exit(0);
    }
    for (int i = 0; i < 50; i++) {
        if (mkdir("deep", 0777) != 0 || chdir("deep") != 0) {
            break;
        }
    }
    for (int i = 0; i < 300; i++) {
        snprintf(name, sizeof name, "file-%d", i / 50);
        const int file = open(name, O_WRONLY | O_CREAT | O_APPEND, 0600);
        (void)!write(file, block, sizeof block);
        close(file);
    }
    usleep(1500000);
    exit(7);
