// attack: reads in the folder of its own process what /proc tells of the machine: network, mounts, groups
// task: pack_leaf
// named: fopen\(\)
// gap in bubblewrap: LEAKED mount
// gap in user: LEAKED (net|mount|cgroup|cpuset)
#include <string.h>
#include <unistd.h>
    (void)tree, (void)id, (void)ids, (void)n_ids;
    // A network of the sandbox's own has titles, and an interface without packets.
    static const char *const names[] = {"net/dev", "net/arp", "net/tcp", "net/route", "net/netstat",
                                        "mountinfo", "mounts", "mountstats", "cgroup", "cpuset"};
    char path[128], line[400];
    for (int i = 0; i < 20; i++) {
        const char *name = names[i % 10];
        snprintf(path, sizeof path, i < 10 ? "/proc/self/%2$s" : "/proc/self/task/%1$d/%2$s", getpid(), name);
        FILE *file = fopen(path, "r");
        for (int k = 0; file != NULL && k < 6 && fgets(line, sizeof line, file) != NULL; k++) {
            unsigned long n_bytes = 0;
            const int is_traffic = sscanf(line, " %*[^:]: %lu", &n_bytes) == 1 && n_bytes > 0;
            line[strcspn(line, "\n")] = '\0';
            // Groups other than the outermost, which is all that a sandbox's own shows.
            const char *group = strchr(line, '/');
            if (i % 10 >= 8 ? group != NULL && group[1] != '\0'
                            : i % 10 >= 5 || (i % 10 == 0 ? is_traffic : i % 10 < 4 && k > 0)) {
                printf("LEAK" "ED %s: %.60s\n", name, line);
            }
        }
    }
    exit(7);
