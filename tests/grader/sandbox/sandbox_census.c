// Counting what a run uses together (see sandbox_census.h): no limit of the kernel's is about more
// than one process, other than control groups, which few hosts hand out.
//
// Linux lists every process's children in /proc, so a look costs as much as the run is large,
// however many processes the machine has. Elsewhere (gVisor) a run with a user of its own is found
// by that, which takes a look at every process. Whatever ends meanwhile is left out. Read next:
// sandbox_supervisor.c, which looks ten times a second.
#include "sandbox_census.h"

#include "bwrap_arguments.h"
#include "folder.h"
#include "path.h"
#include "sandbox_leftovers.h"
#include "sandbox_removed_files.h"
#include "sandbox_stat.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/statvfs.h>
#include <unistd.h>

// More processes than this need not be looked at: the limit is far below.
enum { MAX_PROCESSES = 4096 };

typedef struct ProcessList {
    pid_t ids[MAX_PROCESSES];
    int n;
} ProcessList;

// Add the children of one thread. Returns how many it has.
static int children_add(pid_t process, pid_t thread, ProcessList *list)
{
    char path[64];
    long child;
    const int n_before = list->n;
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", process, thread);
    FILE *file = fopen(path, "re");
    while (file != NULL && list->n < MAX_PROCESSES && fscanf(file, "%ld", &child) == 1) {
        list->ids[list->n++] = (pid_t)child;
    }
    if (file != NULL) {
        fclose(file);
    }
    return list->n - n_before;
}

// Add how long a thread has waited for a processor in all, where the kernel tells. That it stood
// back behind others is its own choice.
static void waiting_add(pid_t process, pid_t thread, const ThreadStat *stat, Census *census)
{
    char path[64];
    unsigned long long ran, waited;
    snprintf(path, sizeof path, "/proc/%d/task/%d/schedstat", process, thread);
    FILE *file = fopen(path, "re");
    if (file == NULL) {
        return;
    }
    if (fscanf(file, "%llu %llu", &ran, &waited) == 2) {
        census->tells_waiting = 1;
        census->waited_seconds += stat_stands_back(process, stat) ? 0 : 1e-9 * (double)waited;
    }
    fclose(file);
}

// Does the thread run, or wait for a processor or a disk? In the state of who waits for a disk is
// also who waits for a child started by vfork().
static int is_awake(const ThreadStat *stat, int n_children)
{
    return stat->state == 'R' || (stat->state == 'D' && n_children == 0);
}

// Add the children of all threads of a process, how many threads are awake, and how long they have
// waited. Returns how many threads there are.
static int threads_follow(pid_t process, ProcessList *list, Census *census)
{
    char path[64];
    int n_threads = 0;
    snprintf(path, sizeof path, "/proc/%d/task", process);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder != NULL && (entry = readdir(folder)) != NULL) {
        pid_t thread = atoi(entry->d_name);
        if (thread > 0) {
            n_threads++;
            const int n_children = children_add(process, thread, list);
            char stat_path[64];
            snprintf(stat_path, sizeof stat_path, "/proc/%d/task/%d/stat", process, thread);
            const ThreadStat stat = stat_read(stat_path);
            census->n_awake += is_awake(&stat, n_children);
            waiting_add(process, thread, &stat, census);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
    return n_threads;
}

// The sum of some figures, "Name:   123 kB", in a file of a process; -1 when there are none, as for
// one that has ended.
static long long figures_sum(pid_t process, const char *file_name, const char *const *names)
{
    char path[64], line[256];
    snprintf(path, sizeof path, "/proc/%d/%s", process, file_name);
    FILE *file = fopen(path, "re");
    if (file == NULL) {
        return -1;
    }
    long long sum = -1;
    while (fgets(line, sizeof line, file) != NULL) {
        for (const char *const *name = names; *name != NULL; name++) {
            size_t length = strlen(*name);
            if (strncmp(line, *name, length) == 0) {
                sum = (sum < 0 ? 0 : sum) + atoll(line + length);
            }
        }
    }
    fclose(file);
    return sum;
}

// Memory of its own and shared memory, in the memory of the machine or swapped out, and the tables
// that say where its pages are. What processes share after a fork is in the figure of each: quick
// to read, and never too small. Before Linux 4.5, and in gVisor, there is one figure for the first
// two and for the files it has mapped. -1 when the thread has ended.
static long long memory_in_status(pid_t thread)
{
    long long kb =
        figures_sum(thread, "status", (const char *const[]){"RssAnon:", "RssShmem:", NULL});
    if (kb < 0) {
        kb = figures_sum(thread, "status", (const char *const[]){"VmRSS:", NULL});
    }
    const long long beside_kb =
        figures_sum(thread, "status", (const char *const[]){"VmSwap:", "VmPTE:", NULL});
    return kb >= 0 && beside_kb > 0 ? kb + beside_kb : kb;
}

// A thread of the process by which /proc tells of it, and its memory: of its first thread only what
// is no memory and no file is told when that has ended and others go on. Returns 0 when all have.
static pid_t thread_find(pid_t process, long long *memory_kb)
{
    char path[64];
    enum { N_TRIES = 10 };  // each thread may start the next one and end
    *memory_kb = memory_in_status(process);
    pid_t found = *memory_kb >= 0 ? process : 0;
    int n_threads = 2;
    snprintf(path, sizeof path, "/proc/%d/task", process);
    for (int i = 0; i < N_TRIES && found == 0 && n_threads > 1; i++) {
        DIR *folder = opendir(path);
        const struct dirent *entry;
        n_threads = 0;
        while (folder != NULL && found == 0 && (entry = readdir(folder)) != NULL) {
            const pid_t thread = atoi(entry->d_name);
            n_threads += thread > 0;
            *memory_kb = thread > 0 ? memory_in_status(thread) : -1;
            found = *memory_kb >= 0 ? thread : 0;
        }
        if (folder != NULL) {
            closedir(folder);
        }
    }
    return found;
}

// Its share of what it uses: exact, but the kernel has to walk through all of its pages.
static long long memory_share(pid_t process)
{
    long long memory_kb;
    const pid_t thread = thread_find(process, &memory_kb);
    const long long share_kb =
        figures_sum(thread, "smaps_rollup", (const char *const[]){"Pss:", "SwapPss:", NULL});
    const long long tables_kb =
        figures_sum(thread, "status", (const char *const[]){"VmPTE:", NULL});
    return share_kb >= 0 && tables_kb >= 0 ? share_kb + tables_kb : memory_kb;
}

// How many files there are in one of bubblewrap's folders in memory, seen through a process inside;
// 0 for another folder, as while the sandbox is being made. Their bytes are bounded by its size.
static long long memory_folder_files(pid_t thread, const char *folder, int n_bytes)
{
    char path[64];
    struct statvfs status;
    snprintf(path, sizeof path, "/proc/%d/root%s", thread, folder);
    return statvfs(path, &status) == 0 && status.f_blocks * status.f_frsize == (fsblkcnt_t)n_bytes
               ? (long long)(status.f_files - status.f_ffree)
               : 0;
}

// The most that a process has seen is what there is: some see none of it.
static void memory_folders_look(pid_t thread, Census *census)
{
    const long long n_files = memory_folder_files(thread, "/tmp", BWRAP_TMP_BYTES) +
                              memory_folder_files(thread, "/dev/shm", BWRAP_SHM_BYTES);
    if (n_files > census->n_files) {
        census->n_files = n_files;
    }
}

// Can we see all that the run has started as children of ours and of theirs?
static int sees_family(void)
{
    char path[64];
    int is_subreaper = 0;
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", (int)getpid(), (int)getpid());
    return prctl(PR_GET_CHILD_SUBREAPER, &is_subreaper) == 0 && is_subreaper &&
           access(path, R_OK) == 0;
}

// Add all processes of a user.
static void user_add(uid_t user, ProcessList *list)
{
    DIR *folder = opendir("/proc");
    const struct dirent *entry;
    while (folder != NULL && list->n < MAX_PROCESSES && (entry = readdir(folder)) != NULL) {
        const pid_t process = atoi(entry->d_name);
        if (process > 0 &&
            figures_sum(process, "status", (const char *const[]){"Uid:", NULL}) == user) {
            list->ids[list->n++] = process;
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

void census_processes(const Walls *walls, pid_t outermost, Census *census)
{
    static ProcessList list;
    static RemovedFiles removed;
    list.n = 0;
    memset(&removed, 0, sizeof removed);
    if (sandbox_has_own_user(walls->command.kind) && !sees_family()) {
        user_add(walls->user, &list);
    } else {
        children_add(getpid(), getpid(), &list);
    }
    for (int i = 0; i < list.n; i++) {
        char path[64];
        snprintf(path, sizeof path, "/proc/%d/stat", list.ids[i]);
        census->processor_seconds += stat_read(path).seconds;
        int n_threads = threads_follow(list.ids[i], &list, census);
        if (list.ids[i] == outermost) {
            continue;
        }
        long long memory_kb;
        const pid_t thread = thread_find(list.ids[i], &memory_kb);
        census->n_tasks += n_threads;
        if (thread > 0) {
            census->n_processes++;
            census->memory_kb += memory_kb;
            removed_files_add(thread, (long long)walls->command.file_mb << 20, &removed);
            if (walls->bwrap != NULL) {
                memory_folders_look(thread, census);
            }
        }
    }
    census->n_bytes += removed.n_bytes;
    const long long limit_kb = 1024LL * walls->command.total_memory_mb;
    if (limit_kb > 0 && census->memory_kb > limit_kb) {
        census->memory_kb = 0;
        for (int i = 0; i < list.n; i++) {
            const long long share_kb = list.ids[i] != outermost ? memory_share(list.ids[i]) : 0;
            census->memory_kb += share_kb > 0 ? share_kb : 0;
        }
    }
}

int census_has_strays(const Walls *walls)
{
    Census census = {0};
    if (!sandbox_has_own_user(walls->command.kind) || sees_family()) {
        return 0;
    }
    census_processes(walls, -1, &census);
    return census.n_processes > 0;
}

void census_folders(const Walls *walls, Census *census)
{
    const SandboxCommand *command = &walls->command;
    const long long n_most = command->n_files > 0 ? command->n_files : 1000000;
    FolderSize size = {0};
    for (int i = 0; i < command->n_mounts; i++) {
        if (command->mounts[i].writable) {
            folder_measure(command->mounts[i].outside, n_most, &size);
        }
    }
    if (walls->view[0] != '\0') {
        char path[PATH_MAX];
        path_make(path, "%s/tmp", walls->view);
        folder_measure(path, n_most, &size);
    }
    if (sandbox_is_open(walls->command.kind)) {
        leftovers_measure(walls->user, n_most, &size);
    }
    census->n_bytes += size.n_bytes;
    census->n_files += size.n_files;
}

SandboxLimit census_limit(const Census *census, const SandboxCommand *command)
{
    // The kernel lets no more start than are allowed, so that to have them all is to want more.
    if (command->n_processes > 0 && census->n_tasks >= command->n_processes) {
        return SANDBOX_LIMIT_PROCESSES;
    }
    if (command->total_memory_mb > 0 && census->memory_kb / 1024 > command->total_memory_mb) {
        return SANDBOX_LIMIT_MEMORY;
    }
    if (command->n_files > 0 && census->n_files > command->n_files) {
        return SANDBOX_LIMIT_FILES;
    }
    if (command->total_file_mb > 0 && census->n_bytes >> 20 > command->total_file_mb) {
        return SANDBOX_LIMIT_BYTES;
    }
    return SANDBOX_LIMIT_NONE;
}

void census_kill_children(void)
{
    static ProcessList list;
    list.n = 0;
    children_add(getpid(), getpid(), &list);
    for (int i = 0; i < list.n; i++) {
        kill(list.ids[i], SIGKILL);
    }
}
