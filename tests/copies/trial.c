// A process with limits of processor time and memory (see trial.h).
#include "trial.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// The addresses that this process has now, in bytes.
static rlim_t addresses_used(void)
{
    unsigned long n_pages = 0;
    FILE *file = fopen("/proc/self/statm", "re");
    if (file != NULL) {
        if (fscanf(file, "%lu", &n_pages) != 1) {
            n_pages = 0;
        }
        fclose(file);
    }
    return (rlim_t)n_pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

// A limit, where there is no lower one.
static void limit_set(int which, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit((__rlimit_resource_t)which, &limit) == 0 && limit.rlim_max > most) {
        limit = (struct rlimit){most, most};
        setrlimit((__rlimit_resource_t)which, &limit);
    }
}

static void limits_set(void)
{
    limit_set(RLIMIT_CPU, TRIAL_SECONDS);
    limit_set(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__  // it needs more addresses than there is memory
    limit_set(RLIMIT_AS, addresses_used() + ((rlim_t)TRIAL_MB << 20));
#else
    (void)addresses_used;
#endif
}

int trial_ends(void (*what)(void *context), void *context)
{
    int status = -1;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        // Its messages would not say what comes of it.
        dup2(open("/dev/null", O_WRONLY | O_CLOEXEC), STDERR_FILENO);
        limits_set();
        what(context);
        _exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}
