// attack: waits, without using any of its CPU time, and ignores every signal
// task: pack_leaf
// named: did not finish in time
// limit: 2
#include <signal.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    for (int signal_id = 1; signal_id < 65; signal_id++) {
        signal(signal_id, SIG_IGN);
    }
    for (int i = 0; i < 600; i++) {
        sleep(1);
    }
