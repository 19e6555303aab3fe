// Running commands beside the watch (see child.h).
#include "child.h"

#include "complain.h"
#include "stats.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_BYTES = 64 * 1024, STOP_MS = 3000 };

// In the new process: never returns.
static void run(char *const words[], int output)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    if (output >= 0) {
        // What is read of it is shown there later.
        if (isatty(STDOUT_FILENO)) {
            setenv("CLICOLOR_FORCE", "1", 1);
        }
        dup2(output, STDOUT_FILENO);
        dup2(output, STDERR_FILENO);
    }
    // The watch is itself run by make, whose switches are not meant for the make that it runs.
    unsetenv("MAKEFLAGS");
    unsetenv("MFLAGS");
    unsetenv("MAKELEVEL");
    execvp(words[0], words);
    complain("desk: %s: cannot be run: %s", words[0], strerror(errno));
    _exit(127);
}

int child_start(Child *child, char *const words[], ChildOutput output)
{
    int ends[2] = {-1, -1};
    free(child->said);
    *child = (Child){.output = -1, .start_ms = stats_clock_ms(), .said = strdup("")};
    if (child->said == NULL || (output == CHILD_IS_READ && pipe2(ends, O_CLOEXEC) != 0)) {
        complain("desk: %s: cannot be run: %s", words[0], strerror(errno));
        return -1;
    }
    child->pid = fork();
    if (child->pid == 0) {
        run(words, ends[1]);
    }
    if (output == CHILD_IS_READ) {
        close(ends[1]);
    }
    if (child->pid < 0) {
        complain("desk: %s: cannot be run: %s", words[0], strerror(errno));
        child->pid = 0;
        if (ends[0] >= 0) {
            close(ends[0]);
        }
        return -1;
    }
    child->output = ends[0];
    return 0;
}

void child_read(Child *child)
{
    char bytes[4096];
    const ssize_t n = read(child->output, bytes, sizeof bytes);
    if (n <= 0) {
        close(child->output);
        child->output = -1;
        return;
    }
    const size_t room = MOST_BYTES - child->said_bytes;
    const size_t taken = (size_t)n < room ? (size_t)n : room;
    char *longer = realloc(child->said, child->said_bytes + taken + 1);
    if (longer != NULL) {
        memcpy(longer + child->said_bytes, bytes, taken);
        child->said = longer;
        child->said_bytes += taken;
        child->said[child->said_bytes] = '\0';
    }
}

double child_seconds(const Child *child)
{
    clockid_t clock;
    struct timespec used = {0};
    if (child->pid != 0 && clock_getcpuclockid(child->pid, &clock) == 0) {
        clock_gettime(clock, &used);
    }
    return (double)used.tv_sec + (double)used.tv_nsec / 1e9;
}

int child_has_ended(Child *child, int *status)
{
    int how;
    if (child->pid == 0 || waitpid(child->pid, &how, WNOHANG) != child->pid) {
        return 0;
    }
    // Somebody that it left behind may hold the other end: what is not there now is not waited for.
    if (child->output >= 0) {
        fcntl(child->output, F_SETFL, O_NONBLOCK);
    }
    while (child->output >= 0) {
        child_read(child);
    }
    kill(-child->pid, SIGKILL);
    child->pid = 0;
    *status = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
    return 1;
}

void child_stop(Child *child)
{
    if (child->pid != 0) {
        const double start = stats_clock_ms();
        int status;
        kill(-child->pid, SIGTERM);
        while (!child_has_ended(child, &status)) {
            if (stats_clock_ms() - start > STOP_MS) {
                kill(-child->pid, SIGKILL);
            }
            usleep(10 * 1000);
        }
    }
    if (child->output >= 0) {
        close(child->output);
        child->output = -1;
    }
}
