// attack: starts processes until there are no more, at most 700
// task: pack_leaf
// named: fork\(\)|too many processes
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 700; i++) {
        if (fork() == 0) {
            sleep(20);
            _exit(0);
        }
    }
    exit(7);
