// attack: a process in a session of its own, without a parent, stays for a minute after the end
// task: pack_leaf
// named: fork\(\)|outlive|left behind
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    if (fork() == 0) {
        setsid();
        if (fork() == 0) {
            close(0), close(1), close(2);
            sleep(60);
        }
        _exit(0);
    }
    usleep(100000);
    exit(0);
