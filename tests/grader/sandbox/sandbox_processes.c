// Counting what a run uses together (see sandbox_processes.h): no limit of the kernel's is about
// more than one process, other than control groups, which few hosts hand out.
//
// Linux lists every process's children in /proc, so a look costs as much as the run is large,
// however many processes the machine has. Elsewhere (gVisor) a run with a user of its own is found
// by that, which takes a look at every process. Whatever ends meanwhile is left out. Read next:
// sandbox_supervisor.c, which looks ten times a second, less often where a look is expensive.
#include "sandbox_processes.h"

#include "bwrap_arguments.h"
#include "folder.h"
#include "path.h"
#include "sandbox_held.h"
#include "sandbox_stat.h"
#include "sandbox_user.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/statvfs.h>
#include <unistd.h>

// What processes share is told apart from what each has by a walk through all of their pages. That
// is done where they seem to use up to twice the memory that is allowed, as one does that starts
// another, and takes some 0.2 s then; who seems to use more uses too much.
enum { MOST_SHARED = 2 };

typedef struct ProcessList {
    pid_t ids[SCAN_MAX_TASKS];
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
    while (file != NULL && list->n < SCAN_MAX_TASKS && fscanf(file, "%ld", &child) == 1) {
        list->ids[list->n++] = (pid_t)child;
    }
    if (file != NULL) {
        fclose(file);
    }
    return list->n - n_before;
}

// Add how long a thread has waited for a processor, where the kernel tells.
static void waiting_add(pid_t process, pid_t thread, int is_own_choice, ProcessScan *scan)
{
    char path[64];
    unsigned long long ran, waited;
    snprintf(path, sizeof path, "/proc/%d/task/%d/schedstat", process, thread);
    FILE *file = fopen(path, "re");
    if (file == NULL) {
        return;
    }
    if (fscanf(file, "%llu %llu", &ran, &waited) == 2 && scan->n_waits < SCAN_MAX_TASKS) {
        scan->tells_waiting = 1;
        scan->waits[scan->n_waits++] =
            (ThreadWait){process, thread, 1e-9 * (double)waited, is_own_choice};
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
static int threads_follow(pid_t process, ProcessList *list, ProcessScan *scan)
{
    char path[64];
    int n_threads = 0;
    const int stands_back = stat_session_stands_back(process);
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
            scan->n_awake += is_awake(&stat, n_children);
            waiting_add(process, thread, stands_back || stat_stands_back(&stat), scan);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
    return n_threads;
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
static void memory_folders_look(pid_t thread, ProcessScan *scan)
{
    const long long n_files = memory_folder_files(thread, "/tmp", BWRAP_TMP_BYTES) +
                              memory_folder_files(thread, "/dev/shm", BWRAP_SHM_BYTES);
    if (n_files > scan->n_files) {
        scan->n_files = n_files;
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
    while (folder != NULL && list->n < SCAN_MAX_TASKS && (entry = readdir(folder)) != NULL) {
        const pid_t process = atoi(entry->d_name);
        long long owner;
        if (process > 0 &&
            stat_figures_read(process, "status", (const char *const[]){"Uid:"}, &owner, 1) == 0 &&
            owner == user) {
            list->ids[list->n++] = process;
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

// Enough seen: a limit on what is counted has been passed, and the run will be ended.
static int is_too_much(const ProcessScan *scan, const SandboxCommand *command)
{
    return (command->n_processes > 0 && scan->n_tasks >= command->n_processes) ||
           scan->n_mappings > SANDBOX_MAX_MAPPINGS || scan->n_open > SANDBOX_MAX_OPEN_FILES;
}

// What one look gathers besides the scan.
typedef struct Look {
    ProcessList list;
    Held held;
    ProcessMemory memory;  // of all together
} Look;

// Look at one process that counts.
static void process_look(const Walls *walls, pid_t process, Look *look, ProcessScan *scan)
{
    ProcessMemory memory;
    const pid_t thread = memory_look(process, &memory);
    if (thread == 0) {
        return;
    }
    scan->n_processes++;
    look->memory.own_kb += memory.own_kb;
    look->memory.shared_kb += memory.shared_kb;
    held_add(thread, (long long)walls->command.file_mb << 20, &look->held);
    scan->n_open = look->held.n_open;
    scan->n_mappings = look->held.n_mappings;
    if (walls->bwrap != NULL) {
        memory_folders_look(thread, scan);
    }
}

// What processes share after a fork once, and not for each.
static void shares_look(Look *look, pid_t outermost)
{
    look->memory = (ProcessMemory){0};
    for (int i = 0; i < look->list.n; i++) {
        ProcessMemory memory;
        if (look->list.ids[i] != outermost && memory_share(look->list.ids[i], &memory) == 0) {
            look->memory.own_kb += memory.own_kb;
            look->memory.shared_kb += memory.shared_kb;
        }
    }
}

// All memory. Of what is shared without a file there is at least what those who share it hold,
// though none of them may have the pages any more.
static long long memory_total(const Look *look)
{
    const long long held_kb = look->held.n_shared_bytes / 1024;
    const long long shared_kb = look->memory.shared_kb;
    return look->memory.own_kb + (shared_kb > held_kb ? shared_kb : held_kb);
}

// Add children that the supervisor, or process 1 inside, has inherited since its own were read: who
// starts another and ends, again and again, would be in no list. Returns how many are new.
static int inherited_add(ProcessList *list)
{
    enum { N_INHERITORS = 4 };  // the supervisor, and the first of the run
    static ProcessList again;
    const int n_before = list->n;
    again.n = 0;
    children_add(getpid(), getpid(), &again);
    for (int i = 0; i < N_INHERITORS - 1 && i < n_before; i++) {
        children_add(list->ids[i], list->ids[i], &again);
    }
    for (int i = 0; i < again.n && list->n < SCAN_MAX_TASKS; i++) {
        int known = 0;
        while (known < list->n && list->ids[known] != again.ids[i]) {
            known++;
        }
        if (known == list->n) {
            list->ids[list->n++] = again.ids[i];
        }
    }
    return list->n - n_before;
}

void scan_processes(const Walls *walls, pid_t outermost, ProcessScan *scan)
{
    static Look look;
    memset(&look, 0, sizeof look);
    const int is_family = !sandbox_has_own_user(walls->command.kind) || sees_family();
    if (is_family) {
        children_add(getpid(), getpid(), &look.list);
    } else {
        user_add(walls->user, &look.list);
    }
    enum { MOST_ROUNDS = 8 };
    for (int i = 0, n_rounds = 0; !is_too_much(scan, &walls->command); i++) {
        if (i == look.list.n &&
            (!is_family || n_rounds++ == MOST_ROUNDS || inherited_add(&look.list) == 0)) {
            break;
        }
        const pid_t process = look.list.ids[i];
        char path[64];
        snprintf(path, sizeof path, "/proc/%d/stat", process);
        scan->processor_seconds += stat_read(path).seconds;
        const int n_threads = threads_follow(process, &look.list, scan);
        if (process != outermost) {
            scan->n_tasks += n_threads;
            process_look(walls, process, &look, scan);
        }
    }
    scan->n_bytes += look.held.n_bytes;
    scan->memory_kb = memory_total(&look);
    const long long limit_kb = 1024LL * walls->command.total_memory_mb;
    if (limit_kb > 0 && scan->memory_kb > limit_kb && scan->memory_kb <= MOST_SHARED * limit_kb) {
        shares_look(&look, outermost);
        scan->memory_kb = memory_total(&look);
    }
}

int scan_has_strays(const Walls *walls)
{
    ProcessScan scan = {0};
    if (!sandbox_has_own_user(walls->command.kind) || sees_family()) {
        return 0;
    }
    scan_processes(walls, -1, &scan);
    return scan.n_processes > 0;
}

void scan_folders(const Walls *walls, ProcessScan *scan)
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
    scan->n_bytes += size.n_bytes;
    scan->n_files += size.n_files;
}

SandboxLimit scan_limit(const ProcessScan *scan, const SandboxCommand *command)
{
    // The kernel lets no more start than are allowed, so that to have them all is to want more.
    if (command->n_processes > 0 && scan->n_tasks >= command->n_processes) {
        return SANDBOX_LIMIT_PROCESSES;
    }
    if (command->total_memory_mb > 0 && scan->memory_kb / 1024 > command->total_memory_mb) {
        return SANDBOX_LIMIT_MEMORY;
    }
    if (scan->n_mappings > SANDBOX_MAX_MAPPINGS) {
        return SANDBOX_LIMIT_MAPPINGS;
    }
    if (scan->n_open > SANDBOX_MAX_OPEN_FILES) {
        return SANDBOX_LIMIT_OPEN_FILES;
    }
    if (command->n_files > 0 && scan->n_files > command->n_files) {
        return SANDBOX_LIMIT_FILES;
    }
    if (command->total_file_mb > 0 && scan->n_bytes >> 20 > command->total_file_mb) {
        return SANDBOX_LIMIT_BYTES;
    }
    return SANDBOX_LIMIT_NONE;
}

void scan_kill_children(void)
{
    static ProcessList list;
    list.n = 0;
    children_add(getpid(), getpid(), &list);
    for (int i = 0; i < list.n; i++) {
        kill(list.ids[i], SIGKILL);
    }
}
