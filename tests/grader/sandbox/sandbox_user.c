// Users of runs (see sandbox_user.h). Read next: sandbox_walls.c.
#include "sandbox_user.h"

#include <errno.h>
#include <grp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// A run's user is this number plus its supervisor's process id, which no other run has at the same
// time. Neither people nor services nor containers are given numbers from here to 0x7fffffff
// (systemd's list, UIDS-GIDS.md), and process ids stay below 2^22.
#define FIRST_USER 0x70000000U
// Who ends a run's processes is no user of a run.
#define FIRST_ENDER (FIRST_USER + (1U << 22))

uid_t user_own(void)
{
    return FIRST_USER + (uid_t)getpid();
}

// Is a number in a map of those that there are here? Its lines hold the first one, whom that is
// outside, and how many follow.
static int is_mapped(const char *map, unsigned long number)
{
    unsigned long first, n_numbers;
    int is_found = 0;
    FILE *file = fopen(map, "re");
    if (file == NULL) {
        return 1;  // a kernel without such maps
    }
    while (!is_found && fscanf(file, "%lu %*u %lu", &first, &n_numbers) == 2) {
        is_found = number >= first && number - first < n_numbers;
    }
    fclose(file);
    return is_found;
}

int user_is_known(uid_t user)
{
    return is_mapped("/proc/self/uid_map", user) && is_mapped("/proc/self/gid_map", user);
}

int user_become(uid_t user)
{
    if (geteuid() != 0) {
        return 0;
    }
    if (setgroups(0, NULL) != 0 || setresgid((gid_t)user, (gid_t)user, (gid_t)user) != 0 ||
        setresuid(user, user, user) != 0) {
        return -1;
    }
    return 0;
}

void user_end(uid_t user)
{
    // Only a process of that user's is stopped by the kernel from hitting anybody else. It kills
    // all of them in one step, so that none can fork away. A signal is let through by its sender's
    // effective user, and by its target's real and saved ones: so they cannot kill it first.
    const pid_t ender = fork();
    if (ender == 0) {
        const uid_t other = FIRST_ENDER + (uid_t)getpid();
        if (setresuid(other, user, other) == 0 && geteuid() >= FIRST_USER) {
            kill(-1, SIGKILL);
        }
        _exit(0);
    }
    // Whoever kills this process's children next shall not meet it before it has done its work.
    while (ender > 0 && waitpid(ender, NULL, 0) < 0 && errno == EINTR)
        ;
}

// ---- What it leaves -----------------------------------------------------------------------------

// The folders in which every user of a Linux system may write. Landlock closes them to a run; on
// other kernels nobody can, but a user that only one run has tells what is of this run. The filter
// of system calls refuses what has no folder: System V's memory, queues and semaphores. Read next:
// sandbox_processes.c, which counts it, and folder.c.
static const char *const open_folders[] = {"/tmp",        "/var/tmp",  "/dev/shm",
                                           "/dev/mqueue", "/run/lock", "/var/crash"};

enum { N_OPEN_FOLDERS = sizeof open_folders / sizeof *open_folders };

// $TMPDIR, where it is none of those.
static const char *own_folder(void)
{
    const char *folder = getenv("TMPDIR");
    if (folder == NULL || folder[0] == '\0') {
        return NULL;
    }
    for (size_t i = 0; i < N_OPEN_FOLDERS; i++) {
        if (strcmp(folder, open_folders[i]) == 0) {
            return NULL;
        }
    }
    return folder;
}

void leftovers_measure(uid_t user, long long n_files_most, FolderSize *size)
{
    for (size_t i = 0; i < N_OPEN_FOLDERS; i++) {
        folder_measure_of(open_folders[i], user, n_files_most, size);
    }
    if (own_folder() != NULL) {
        folder_measure_of(own_folder(), user, n_files_most, size);
    }
}

void leftovers_remove(uid_t user)
{
    for (size_t i = 0; i < N_OPEN_FOLDERS; i++) {
        folder_remove_of(open_folders[i], user);
    }
    if (own_folder() != NULL) {
        folder_remove_of(own_folder(), user);
    }
}
