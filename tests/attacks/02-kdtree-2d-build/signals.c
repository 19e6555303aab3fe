// attack: kills its parent, process 1, a stranger of the same user, and whomever it may
// task: pack_leaf
// named: kill\(\)
#include <signal.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    kill(@BYSTANDER@, SIGKILL);
    // Outside of any sandbox the next ones would end the tester's own session: not there.
    if (getuid() != @TESTER@ || getpid() < 100) {
        kill(getppid(), SIGKILL);
        kill(1, SIGKILL);
        kill(0, SIGTERM);
        kill(-1, SIGKILL);
    }
    exit(7);
