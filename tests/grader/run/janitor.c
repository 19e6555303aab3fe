// Clearing up behind a grader that was ended (see janitor.h).
//
// A handler of signals could not do it: sandboxes end after the grader, and nothing hears a
// SIGKILL. Used by workdir.c.
#include "janitor.h"

#include "descriptors.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_TRIES = 20, WAIT_US = 100 * 1000 };

// In the new process: never returns.
static void wait_and_clear(int lifeline, int (*clear)(void *what), void *what)
{
    char word;
    // Ctrl-C goes to the grader's group: that is not us.
    setsid();
    signal(SIGINT, SIG_IGN), signal(SIGTERM, SIG_IGN), signal(SIGHUP, SIG_IGN);
    descriptors_close(0, lifeline - 1);
    descriptors_close(lifeline + 1, INT_MAX);
    ssize_t n;
    do {
        n = read(lifeline, &word, 1);
    } while (n < 0 && errno == EINTR);
    for (int i = 0; n == 0 && i < MOST_TRIES && clear(what) != 0; i++) {
        usleep(WAIT_US);
    }
    _exit(0);
}

int janitor_start(Janitor *janitor, int (*clear)(void *what), void *what)
{
    int ends[2];
    *janitor = (Janitor){.lifeline = -1};
    if (pipe2(ends, O_CLOEXEC) != 0) {
        return -1;
    }
    janitor->pid = fork();
    if (janitor->pid == 0) {
        wait_and_clear(ends[0], clear, what);
    }
    close(ends[0]);
    if (janitor->pid < 0) {
        janitor->pid = 0;
        close(ends[1]);
        return -1;
    }
    janitor->lifeline = ends[1];
    return 0;
}

void janitor_dismiss(Janitor *janitor)
{
    if (janitor->pid == 0) {
        return;
    }
    const int is_told = write(janitor->lifeline, "", 1) == 1;
    close(janitor->lifeline);
    while (is_told && waitpid(janitor->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    *janitor = (Janitor){.lifeline = -1};
}
