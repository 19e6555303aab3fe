// attack: asks for a core dump and crashes
// task: pack_leaf
// named: signal 6
#include <sys/resource.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    struct rlimit limit = {RLIM_INFINITY, RLIM_INFINITY};
    setrlimit(RLIMIT_CORE, &limit);
    (void)!chdir("out");
    abort();
