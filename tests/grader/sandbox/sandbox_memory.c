// Reading a process's memory (see sandbox_memory.h). Read next: sandbox_census.c, which adds it up.
#include "sandbox_memory.h"

#include "sandbox_stat.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>

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
