// Limits on each process (see sandbox_limits.h); those on all together are sandbox_processes.c's.
#include "sandbox_limits.h"

#include "sandbox_system.h"

#include <sys/resource.h>

#define OPEN_FILES_LIMIT 256

// Signals that wait to be handled, and timers: the kernel keeps some 100 and 400 bytes for each.
#define PENDING_SIGNALS_LIMIT 1024

// The lower of a limit and what is allowed already.
static rlim_t limit_lower(__rlimit_resource_t resource, rlim_t value)
{
    struct rlimit limit = {.rlim_max = RLIM_INFINITY};
    getrlimit(resource, &limit);
    return limit.rlim_max == RLIM_INFINITY || value < limit.rlim_max ? value : limit.rlim_max;
}

static int limit_set(__rlimit_resource_t resource, rlim_t value)
{
    const rlim_t lower = limit_lower(resource, value);
    return setrlimit(resource, &(struct rlimit){.rlim_cur = lower, .rlim_max = lower});
}

unsigned long long limits_processes(const SandboxCommand *command)
{
    const rlim_t wanted = command->n_processes > 0 ? (rlim_t)command->n_processes : RLIM_INFINITY;
    const rlim_t lower = limit_lower(RLIMIT_NPROC, wanted);
    return lower == RLIM_INFINITY ? 0 : lower;
}

// The drivers of graphics cards reserve more addresses than the machine has memory. Beside them
// only what a process may write for itself is limited; what it shares, the scan finds.
static int memory_limit_set(int megabytes)
{
    return limit_set(has_graphics_card() ? RLIMIT_DATA : RLIMIT_AS, (rlim_t)megabytes << 20);
}

int limits_set(const SandboxCommand *command)
{
    const rlim_t megabyte = 1024 * 1024;
    // Where the user is the run's own, its processes only are counted. Bubblewrap has this limit
    // set inside, for the same reason; without walls it would count all that the user runs here.
    if (sandbox_has_own_user(command->kind) && command->n_processes > 0 &&
        limit_set(RLIMIT_NPROC, (rlim_t)command->n_processes) != 0) {
        return -1;
    }
    if (command->memory_mb > 0 && memory_limit_set(command->memory_mb) != 0) {
        return -1;
    }
    // Soft and hard alike: PoCL swallows SIGXCPU, the hard limit's SIGKILL nobody can.
    // The supervisor looks at the time of all processes together; this is for what it cannot see.
    if (limit_set(RLIMIT_CPU, (rlim_t)command->time.processor + 1) != 0 ||
        limit_set(RLIMIT_FSIZE, (rlim_t)command->file_mb * megabyte) != 0 ||
        limit_set(RLIMIT_NOFILE, OPEN_FILES_LIMIT) != 0 ||
        limit_set(RLIMIT_SIGPENDING, PENDING_SIGNALS_LIMIT) != 0 ||
        limit_set(RLIMIT_CORE, 0) != 0) {
        return -1;
    }
    return 0;
}
