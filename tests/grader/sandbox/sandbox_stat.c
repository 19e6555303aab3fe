// Reading what /proc has of a process (see sandbox_stat.h).
#include "sandbox_stat.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

ThreadStat stat_read(const char *path)
{
    char text[1024] = "";
    ThreadStat stat = {.state = 'X'}, found = stat;
    FILE *file = fopen(path, "re");
    if (file == NULL) {
        return stat;
    }
    const size_t n = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[n] = '\0';
    // The second field is the command's name in parentheses, which may hold anything.
    const char *rest = strrchr(text, ')');
    unsigned long user, system;
    long children_user, children_system;
    if (rest != NULL &&
        sscanf(rest,
               ") %c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %ld %ld %*d %d %*d %*d %*u "
               "%*u %*d %*u %*u %*u %*u %*u %*u %*u %*u %*u %*u %*u %*u %*u %*d %*d %*u %d",
               &found.state, &user, &system, &children_user, &children_system, &found.nice,
               &found.policy) == 7) {
        stat = found;
        stat.seconds = ((double)(user + system) + (double)(children_user + children_system)) /
                       (double)sysconf(_SC_CLK_TCK);
    }
    return stat;
}

int stat_stands_back(const ThreadStat *stat)
{
    static ThreadStat own;  // of the calling process, which never changes it
    if (own.state == 0) {
        own = stat_read("/proc/self/stat");
    }
    return stat->nice > own.nice || stat->policy != own.policy;
}

int stat_session_stands_back(pid_t process)
{
    char path[64];
    int nice = 0;
    snprintf(path, sizeof path, "/proc/%d/autogroup", (int)process);
    FILE *file = fopen(path, "re");  // none where the kernel knows no such groups
    if (file != NULL) {
        if (fscanf(file, "%*s nice %d", &nice) != 1) {
            nice = 0;
        }
        fclose(file);
    }
    return nice > 0;
}

int stat_figures_read(pid_t process, const char *file_name, const char *const names[],
                      long long figures[], int n)
{
    char path[64], line[256];
    for (int i = 0; i < n; i++) {
        figures[i] = -1;
    }
    snprintf(path, sizeof path, "/proc/%d/%s", (int)process, file_name);
    FILE *file = fopen(path, "re");
    if (file == NULL) {
        return -1;
    }
    while (fgets(line, sizeof line, file) != NULL) {
        for (int i = 0; i < n; i++) {
            const size_t length = strlen(names[i]);
            if (strncmp(line, names[i], length) == 0) {
                figures[i] = atoll(line + length);
            }
        }
    }
    fclose(file);
    return 0;
}
