// The folders in which every user of a Linux system may write (see sandbox_leftovers.h). Landlock
// closes them to a run; on other kernels nobody can, but a user that only one run has tells what is
// of this run. Read next: sandbox_census.c, which counts it, and folder.c.
#include "sandbox_leftovers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>

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

// System V's memory, queues and semaphores have no folder. The filter of system calls refuses them;
// this is for where there is none.
typedef struct SystemV {
    const char *list;
    int uid_column;  // from 1; the second is the id
} SystemV;

static const SystemV system_v[] = {
    {"/proc/sysvipc/shm", 8},
    {"/proc/sysvipc/msg", 8},
    {"/proc/sysvipc/sem", 5},
};

static void system_v_remove(int kind, int id)
{
    switch (kind) {
    case 0:
        shmctl(id, IPC_RMID, NULL);
        break;
    case 1:
        msgctl(id, IPC_RMID, NULL);
        break;
    default:
        semctl(id, 0, IPC_RMID);
    }
}

// Remove what is the user's in one of the lists.
static void system_v_clear(int kind, uid_t user)
{
    char line[512];
    FILE *list = fopen(system_v[kind].list, "re");
    while (list != NULL && fgets(line, sizeof line, list) != NULL) {
        long long id = -1, uid = -1;
        char *rest = line;
        for (int column = 1; column <= system_v[kind].uid_column; column++) {
            uid = strtoll(rest, &rest, 10);
            id = column == 2 ? uid : id;
        }
        if (uid == user) {
            system_v_remove(kind, (int)id);
        }
    }
    if (list != NULL) {
        fclose(list);
    }
}

void leftovers_remove(uid_t user)
{
    for (int kind = 0; kind < (int)(sizeof system_v / sizeof *system_v); kind++) {
        system_v_clear(kind, user);
    }
    for (size_t i = 0; i < N_OPEN_FOLDERS; i++) {
        folder_remove_of(open_folders[i], user);
    }
    if (own_folder() != NULL) {
        folder_remove_of(own_folder(), user);
    }
}
