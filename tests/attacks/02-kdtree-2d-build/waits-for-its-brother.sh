#!/bin/sh
# attack: waits as if for a disk, for a child made by vfork() that is its parent's: neither time runs, and the grader is kept for minutes
# limit: 1
# score: 100
# named: it waited, without using a processor|does it wait for a disk, or for processes that it started
cat >>kdtree2d_build.c <<'C'
#include <sched.h>
#include <signal.h>
#include <unistd.h>
static char child_stack[65536];
static int sleep_on(void *nothing)
{
    (void)nothing;
    for (;;) {
        pause();
    }
}
__attribute__((constructor)) static void hold(void)
{
    if (fork() == 0) {
        clone(sleep_on, child_stack + 65000, CLONE_VFORK | CLONE_VM | CLONE_PARENT | SIGCHLD, NULL);
    }
    for (;;) {
        pause();
    }
}
C
