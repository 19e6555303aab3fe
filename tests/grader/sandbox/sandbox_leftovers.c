// The folders in which every user of a Linux system may write (see sandbox_leftovers.h). Landlock
// closes them to a run; on other kernels nobody can, but a user that only one run has tells what is
// of this run. The filter of system calls refuses what has no folder: System V's memory, queues and
// semaphores. Read next: sandbox_census.c, which counts it, and folder.c.
#include "sandbox_leftovers.h"

#include <stdlib.h>
#include <string.h>

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
