// Becoming a run's leader (see sandbox_leader.h).
#include "sandbox_leader.h"

#include "descriptors.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Standard output and errors, and the walls' two descriptors; nothing else of the supervisor's.
static int descriptors_arrange(int output, int status, int filter)
{
    // Out of the way of the numbers that are wanted.
    output = fcntl(output, F_DUPFD, WALLS_FILTER_DESCRIPTOR + 1);
    status = fcntl(status, F_DUPFD, WALLS_FILTER_DESCRIPTOR + 1);
    filter = fcntl(filter, F_DUPFD, WALLS_FILTER_DESCRIPTOR + 1);
    if (output < 0 || status < 0 || filter < 0 || dup2(output, STDOUT_FILENO) < 0 ||
        dup2(output, STDERR_FILENO) < 0 || dup2(status, WALLS_STATUS_DESCRIPTOR) < 0 ||
        dup2(filter, WALLS_FILTER_DESCRIPTOR) < 0) {
        return -1;
    }
    if (descriptors_close(STDERR_FILENO + 1, WALLS_STATUS_DESCRIPTOR - 1) != 0) {
        return -1;
    }
    return descriptors_close(WALLS_FILTER_DESCRIPTOR + 1, INT_MAX);
}

// When the machine runs out of memory, the kernel shall choose what is inside and not the grader.
static void sacrifice_offer(void)
{
    int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (file >= 0) {
        // Without it, the kernel chooses as it always does.
        ssize_t ignored = write(file, "1000", 4);
        (void)ignored;
        close(file);
    }
}

_Noreturn void leader_become(const Walls *walls, int output, int status)
{
    const char *step = "cannot arrange its files";
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    sacrifice_offer();
    if (setsid() >= 0 && descriptors_arrange(output, status, walls->filter) == 0 &&
        chdir("/") == 0) {
        umask(022);
        walls_enter(walls, &step);
        if (errno == ENOENT && walls->bwrap != NULL) {
            dprintf(STDERR_FILENO, "bwrap not found: install bubblewrap\n");
            _exit(127);
        }
    }
    dprintf(STDERR_FILENO, "%s: %s\n", step, strerror(errno));
    _exit(127);
}
