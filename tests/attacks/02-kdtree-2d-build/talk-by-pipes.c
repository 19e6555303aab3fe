// attack: uses up the memory that a user may have in pipes, which another run of the user would feel
// task: pack_leaf
// named: fork\(\)
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    int first[2], ends[2];
    // Where other runs are this user, too, a new pipe may be small from the start. Under an ordinary
    // user they are: a known gap.
    if (getuid() != @TESTER@ && pipe(first) == 0 && fcntl(first[0], F_GETPIPE_SZ) < 65536) {
        printf("LEAK" "ED: another process of this user has many pipes\n");
    }
    for (int i = 0; i < 12; i++) {
        if (fork() == 0) {
            while (pipe(ends) == 0) {
            }
            usleep(500000);
            _exit(0);
        }
    }
    usleep(600000);
    exit(7);
