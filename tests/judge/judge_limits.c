// Limiting the judge (see judge_limits.h).
#include "judge_limits.h"

#include <sys/resource.h>
#include <sys/time.h>

void limit_time(int seconds)
{
    const struct itimerval limit = {.it_value = {.tv_sec = seconds}};
    setitimer(ITIMER_PROF, &limit, NULL);
}

void limit_memory(size_t n_bytes)
{
#ifdef __SANITIZE_ADDRESS__
    (void)n_bytes;
#else
    const struct rlimit limit = {n_bytes, n_bytes};
    setrlimit(RLIMIT_AS, &limit);
#endif
}
