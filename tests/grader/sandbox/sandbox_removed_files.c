// Finding removed files that processes hold (see sandbox_removed_files.h).
//
// What is open is listed in /proc/T/fd, what is mapped in /proc/T/maps: there a name ends with
// " (deleted)", and the link beside it, in /proc/T/map_files, leads to the file itself. Read next:
// sandbox_census.c.
#include "sandbox_removed_files.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

// Is the file met for the first time? Beyond a table half full, of thousands, each counts as often
// as it is held: too much is as wrong there as it would be right.
static int is_new(RemovedFiles *files, dev_t device, ino_t number)
{
    size_t slot = (size_t)(number * 2654435761U ^ device) % REMOVED_FILES_SLOTS;
    while (files->seen[slot].number != 0) {
        if (files->seen[slot].number == number && files->seen[slot].device == device) {
            return 0;
        }
        slot = (slot + 1) % REMOVED_FILES_SLOTS;
    }
    if (files->n_seen < REMOVED_FILES_SLOTS / 2) {
        files->seen[slot].device = device;
        files->seen[slot].number = number;
        files->n_seen++;
    }
    return 1;
}

static void file_add(const struct stat *status, RemovedFiles *files)
{
    if (S_ISREG(status->st_mode) && status->st_nlink == 0 &&
        is_new(files, status->st_dev, status->st_ino)) {
        files->n_bytes += (long long)status->st_blocks * 512;
    }
}

static void open_files_add(pid_t thread, RemovedFiles *files)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%d/fd", thread);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder != NULL && (entry = readdir(folder)) != NULL) {
        struct stat status;
        if (fstatat(dirfd(folder), entry->d_name, &status, 0) == 0) {
            file_add(&status, files);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

// Does a line of maps end with the name of a removed file? Memory that processes share looks like
// one; it counts as memory. Nobody inside can have a file of that name.
static int is_removed(const char *line)
{
    static const char removed[] = " (deleted)\n", shared[] = " /dev/zero (deleted)\n";
    const size_t length = strlen(line);
    return length > sizeof shared && strcmp(line + length - strlen(removed), removed) == 0 &&
           strcmp(line + length - strlen(shared), shared) != 0;
}

// Add the file of one line of maps: START-END RIGHTS OFFSET MAJOR:MINOR NUMBER  NAME
static void mapping_add(pid_t thread, const char *line, long long largest, RemovedFiles *files)
{
    unsigned long start, end, number;
    unsigned major, minor;
    char path[96];
    struct stat status;
    if (!is_removed(line) ||
        sscanf(line, "%lx-%lx %*s %*s %x:%x %lu", &start, &end, &major, &minor, &number) != 5) {
        return;
    }
    snprintf(path, sizeof path, "/proc/%d/map_files/%lx-%lx", thread, start, end);
    if (stat(path, &status) == 0) {
        file_add(&status, files);
    } else if (is_new(files, makedev(major, minor), number)) {
        files->n_bytes += largest;
    }
}

static void mapped_files_add(pid_t thread, long long largest, RemovedFiles *files)
{
    char path[64], *line = NULL;
    size_t n_room = 0;
    snprintf(path, sizeof path, "/proc/%d/maps", thread);
    FILE *maps = fopen(path, "re");
    while (maps != NULL && getline(&line, &n_room, maps) > 0) {
        mapping_add(thread, line, largest, files);
    }
    if (maps != NULL) {
        fclose(maps);
    }
    free(line);
}

void removed_files_add(pid_t thread, long long largest, RemovedFiles *files)
{
    open_files_add(thread, files);
    mapped_files_add(thread, largest, files);
}
