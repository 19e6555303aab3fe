// left_behind: run a command, then see whether any process that it started is still there.
//
//     left_behind COMMAND ARGUMENT...
//
// Used by suites/attacks.sh around the grader. Every process that loses its parent comes to this
// one, so nothing can hide by a double fork or a new session. What is left gets killed. Exit
// status: the command's, or 99 after one message when something was left behind.
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { EXIT_LEFT_BEHIND = 99, EXIT_FAULT = 98 };

// Processes that were killed still have to be collected by their parents: so long they may take.
static const double grace_seconds = 2;

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static _Noreturn void fault(const char *what)
{
    fprintf(stderr, "left_behind: %s: %s\n", what, strerror(errno));
    exit(EXIT_FAULT);
}

// Wait for all children to end. Returns how many are alive after the time of grace; they inherit
// nothing that would keep a pipe of ours open, so nobody waits for them.
static int has_children(void)
{
    const double deadline = seconds_now() + grace_seconds;
    while (seconds_now() < deadline) {
        const pid_t ended = waitpid(-1, NULL, WNOHANG);
        if (ended < 0) {
            return 0;
        }
        if (ended == 0) {
            nanosleep(&(struct timespec){.tv_nsec = 10 * 1000 * 1000}, NULL);
        }
    }
    return 1;
}

// Kill all children, and theirs as they come to us. Prints each one's name.
static void children_kill(void)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/self/task/%d/children", (int)getpid());
    for (int round = 0; round < 1000; round++) {
        FILE *list = fopen(path, "r");
        int pid;
        int n_killed = 0;
        while (list != NULL && fscanf(list, "%d", &pid) == 1) {
            n_killed += kill(pid, SIGKILL) == 0;
        }
        if (list != NULL) {
            fclose(list);
        }
        if (n_killed == 0) {
            return;
        }
        while (waitpid(-1, NULL, WNOHANG) > 0) {
        }
    }
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        fprintf(stderr, "usage: left_behind COMMAND ARGUMENT...\n");
        return EXIT_FAULT;
    }
    if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0) {
        fault("cannot become a subreaper");
    }
    const pid_t command = fork();
    if (command < 0) {
        fault("cannot start a process");
    }
    if (command == 0) {
        execvp(argv[1], argv + 1);
        fault(argv[1]);
    }
    int status;
    while (waitpid(command, &status, 0) < 0) {
        if (errno != EINTR) {
            fault("cannot wait");
        }
    }
    if (has_children()) {
        fprintf(stderr, "left_behind: a process was left behind\n");
        children_kill();
        return EXIT_LEFT_BEHIND;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
