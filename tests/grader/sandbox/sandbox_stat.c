// Reading what /proc has of a process (see sandbox_stat.h). Read next: sandbox_processes.c, which
// adds it up.
#include "sandbox_stat.h"

#include <dirent.h>
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

// ---- Memory -------------------------------------------------------------------------------------

// What is not there is nothing.
static long long found(long long figure)
{
    return figure > 0 ? figure : 0;
}

// Before Linux 4.5, and in gVisor, there is one figure for memory of its own, shared memory and the
// files it has mapped. Returns 0, or -1 when the thread has ended.
static int status_read(pid_t thread, ProcessMemory *memory)
{
    enum { ANON, SHMEM, ALL, SWAP, TABLES, N_FIGURES };
    static const char *const names[] = {"RssAnon:", "RssShmem:", "VmRSS:", "VmSwap:", "VmPTE:"};
    long long kb[N_FIGURES];
    if (stat_figures_read(thread, "status", names, kb, N_FIGURES) != 0 || kb[ALL] < 0) {
        return -1;
    }
    memory->own_kb = (kb[ANON] >= 0 ? kb[ANON] : kb[ALL]) + found(kb[SWAP]) + found(kb[TABLES]);
    memory->shared_kb = found(kb[SHMEM]);
    return 0;
}

// Of the first thread /proc tells only what is no memory and no file when that has ended and others
// go on.
pid_t memory_look(pid_t process, ProcessMemory *memory)
{
    char path[64];
    enum { N_TRIES = 10 };  // each thread may start the next one and end
    pid_t teller = status_read(process, memory) == 0 ? process : 0;
    int n_threads = 2;
    snprintf(path, sizeof path, "/proc/%d/task", process);
    for (int i = 0; i < N_TRIES && teller == 0 && n_threads > 1; i++) {
        DIR *folder = opendir(path);
        const struct dirent *entry;
        n_threads = 0;
        while (folder != NULL && teller == 0 && (entry = readdir(folder)) != NULL) {
            const pid_t thread = atoi(entry->d_name);
            n_threads += thread > 0;
            teller = thread > 0 && status_read(thread, memory) == 0 ? thread : 0;
        }
        if (folder != NULL) {
            closedir(folder);
        }
    }
    return teller;
}

int memory_share(pid_t process, ProcessMemory *memory)
{
    enum { ALL, SHMEM, SWAP, N_FIGURES };
    static const char *const names[] = {"Pss:", "Pss_Shmem:", "SwapPss:"};
    static const char *const tables_name[] = {"VmPTE:"};
    long long kb[N_FIGURES], tables_kb;
    const pid_t thread = memory_look(process, memory);
    if (thread == 0) {
        return -1;
    }
    if (stat_figures_read(thread, "smaps_rollup", names, kb, N_FIGURES) == 0 && kb[ALL] >= 0 &&
        stat_figures_read(thread, "status", tables_name, &tables_kb, 1) == 0) {
        memory->shared_kb = found(kb[SHMEM]);
        memory->own_kb = kb[ALL] - memory->shared_kb + found(kb[SWAP]) + found(tables_kb);
    }
    return 0;
}
