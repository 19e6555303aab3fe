// Finding what processes hold (see sandbox_held.h).
//
// What is open is listed in /proc/T/fd, what is mapped in /proc/T/maps: there a name ends with
// " (deleted)", and the link beside it, in /proc/T/map_files, leads to the file itself. Read next:
// sandbox_processes.c.
#include "sandbox_held.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

// How long a line of maps may be and count as one mapping; a longer one counts as several.
enum { LINE_BYTES = 256 };

static size_t slot_find(const Held *held, dev_t device, ino_t number)
{
    size_t slot = (size_t)(number * 2654435761U ^ device) % HELD_SLOTS;
    while (held->seen[slot].number != 0 &&
           (held->seen[slot].number != number || held->seen[slot].device != device)) {
        slot = (slot + 1) % HELD_SLOTS;
    }
    return slot;
}

// Is the file met for the first time? Beyond a table half full, of thousands, each counts as often
// as it is held: too much is as wrong there as it would be right.
static int is_new(Held *held, dev_t device, ino_t number)
{
    const size_t slot = slot_find(held, device, number);
    if (held->seen[slot].number != 0) {
        return 0;
    }
    if (held->n_seen < HELD_SLOTS / 2) {
        held->seen[slot].device = device;
        held->seen[slot].number = number;
        held->n_seen++;
    }
    return 1;
}

static void file_add(const struct stat *status, Held *held, long long *n_bytes)
{
    if (S_ISREG(status->st_mode) && status->st_nlink == 0 &&
        is_new(held, status->st_dev, status->st_ino)) {
        *n_bytes += (long long)status->st_blocks * 512;
    }
}

static void open_files_add(pid_t thread, Held *held)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%d/fd", thread);
    DIR *folder = opendir(path);
    const struct dirent *entry;
    while (folder != NULL && held->n_open <= SANDBOX_MAX_OPEN_FILES &&
           (entry = readdir(folder)) != NULL) {
        struct stat status;
        if (entry->d_name[0] != '.' && fstatat(dirfd(folder), entry->d_name, &status, 0) == 0) {
            held->n_open++;
            file_add(&status, held, &held->n_bytes);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

static int ends_with(const char *line, size_t length, const char *end)
{
    const size_t n = strlen(end);
    return length > n && memcmp(line + length - n, end, n) == 0;
}

// Add the file of one line of maps: START-END RIGHTS OFFSET MAJOR:MINOR NUMBER  NAME
// Memory that processes share looks like a removed file; nobody inside can remove the one of that
// name, but may have one whose name only ends so.
static void mapping_add(pid_t thread, const char *line, size_t length, long long largest,
                        Held *held)
{
    unsigned long start, end, number;
    unsigned major, minor;
    char path[96];
    struct stat status;
    held->n_mappings += 1 + (int)(length / LINE_BYTES);
    if (!ends_with(line, length, " (deleted)\n") ||
        sscanf(line, "%lx-%lx %*s %*s %x:%x %lu", &start, &end, &major, &minor, &number) != 5) {
        return;
    }
    // One of a thousand mappings of a file: its size need not be asked again. (Some file systems
    // call the device otherwise here; then it is.)
    const dev_t device = makedev(major, minor);
    if (held->seen[slot_find(held, device, number)].number != 0) {
        return;
    }
    const char *name = strchr(line, '/');
    const int is_shared = name != NULL && strcmp(name, "/dev/zero (deleted)\n") == 0;
    snprintf(path, sizeof path, "/proc/%d/map_files/%lx-%lx", thread, start, end);
    if (stat(path, &status) == 0) {
        file_add(&status, held, is_shared ? &held->n_shared_bytes : &held->n_bytes);
    } else if (is_new(held, device, number)) {
        // Not told, or the process has ended meanwhile: the most that it can be.
        *(is_shared ? &held->n_shared_bytes : &held->n_bytes) +=
            is_shared ? (long long)(end - start) : largest;
    }
}

static void mapped_files_add(pid_t thread, long long largest, Held *held)
{
    char path[64], *line = NULL;
    size_t n_room = 0;
    ssize_t length;
    snprintf(path, sizeof path, "/proc/%d/maps", thread);
    FILE *maps = fopen(path, "re");
    while (maps != NULL && held->n_mappings <= SANDBOX_MAX_MAPPINGS &&
           (length = getline(&line, &n_room, maps)) > 0) {
        mapping_add(thread, line, (size_t)length, largest, held);
    }
    if (maps != NULL) {
        fclose(maps);
    }
    free(line);
}

// A program that runs on while its file is removed need not have it open or mapped.
static void program_add(pid_t thread, Held *held)
{
    char path[64];
    struct stat status;
    snprintf(path, sizeof path, "/proc/%d/exe", thread);
    if (stat(path, &status) == 0) {
        file_add(&status, held, &held->n_bytes);
    }
}

void held_add(pid_t thread, long long largest, Held *held)
{
    open_files_add(thread, held);
    program_add(thread, held);
    mapped_files_add(thread, largest, held);
}
