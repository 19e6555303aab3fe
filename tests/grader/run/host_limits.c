// Raising the limits that a shell has set (see host_limits.h).
#include "host_limits.h"

#include "run_end.h"

#include <stdio.h>
#include <sys/resource.h>

typedef struct HostLimit {
    __rlimit_resource_t resource;
    rlim_t needed;
    const char *what, *option;
} HostLimit;

#define MEGABYTE ((rlim_t)1 << 20)

// The compiler and PoCL write libraries of some megabytes, a run up to FILE_MB.
static const HostLimit limits[] = {
    {RLIMIT_FSIZE, FILE_MB *MEGABYTE, "bytes in a file", "ulimit -f"},
    {RLIMIT_AS, MEMORY_MB *MEGABYTE, "bytes of addresses", "ulimit -v"},
    {RLIMIT_DATA, MEMORY_MB *MEGABYTE, "bytes of memory", "ulimit -d"},
    {RLIMIT_NOFILE, 256, "open files", "ulimit -n"},
};

int host_limits_raise(void)
{
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        const HostLimit *limit = &limits[i];
        struct rlimit here;
        if (getrlimit(limit->resource, &here) != 0 || here.rlim_cur >= limit->needed) {
            continue;
        }
        if (here.rlim_max < limit->needed) {
            fprintf(stderr,
                    "grade: found at most %llu %s allowed here (%s), expected %llu; start the "
                    "grader from a shell without this limit\n",
                    (unsigned long long)here.rlim_max, limit->what, limit->option,
                    (unsigned long long)limit->needed);
            return -1;
        }
        here.rlim_cur = here.rlim_max;
        setrlimit(limit->resource, &here);
    }
    return 0;
}
