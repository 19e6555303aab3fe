// attack: reads what counts the doings of the whole machine, which another run can move
// task: pack_leaf
// named: /proc/loadavg
// gap in user: LEAKED /proc
    (void)tree, (void)id, (void)ids, (void)n_ids;
    static const char *const paths[] = {
        "/proc/loadavg", "/proc/stat", "/proc/uptime", "/proc/vmstat", "/proc/locks", "/proc/diskstats",
        "/proc/softirqs", "/proc/interrupts", "/proc/buddyinfo", "/proc/key-users", "/proc/pressure/cpu",
        "/proc/sys/fs/file-nr", "/proc/sys/fs/inode-nr", "/proc/sys/kernel/pty/nr",
        "/proc/sys/kernel/random/entropy_avail"};
    char line[100];
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        FILE *file = fopen(paths[i], "r");
        if (file != NULL && fgets(line, sizeof line, file) != NULL) {
            printf("LEAK" "ED %s: %s", paths[i], line);
        }
    }
    // What may be written must not be: it would outlive the limits on folders.
    FILE *left = fopen("/proc/sys/left", "w");
    if (left != NULL) {
        printf("LEAK" "ED: /proc/sys can be written\n");
    }
    exit(7);
