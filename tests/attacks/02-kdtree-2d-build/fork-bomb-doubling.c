// attack: every process starts another one, 10 times over: 1024 at most
// task: pack_leaf
// named: fork\(\)|too many processes
// limit: 2
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int i = 0; i < 10; i++) {
        (void)!fork();
    }
    sleep(20);
    exit(7);
