// Staging whatever was handed in (see submission.h).
//
// A folder is staged as it is. Where a file is not in it, the archives beside the others are
// unpacked, each to a folder of its own. Read next: unpack_run.h, stage.h.
#include "submission.h"

#include "complain.h"
#include "contents.h"
#include "file_names.h"
#include "message.h"
#include "path.h"
#include "places.h"
#include "stage.h"
#include "unpack_run.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int machinery_fault(const char *path, int fault)
{
    complain("%s: %s", path, strerror(fault));
    return -1;
}

// What is staged from.
typedef struct Sources {
    const Workshop *workshop;
    char folders[STAGE_MAX_SOURCES][PATH_MAX];
    char *archives[STAGE_MAX_SOURCES];  // their names, owned
    StageSource all[STAGE_MAX_SOURCES];
    int n;
    int n_unpacked;  // also those that could not be
    char *said;      // while unpacking, or NULL; owned
} Sources;

// What was said before, and what is said now. Takes both over; either may be NULL.
static char *messages_join(char *first, char *second)
{
    if (first == NULL || second == NULL) {
        return first != NULL ? first : second;
    }
    char *both = message_new("%s\n%s", first, second);
    free(first);
    free(second);
    return both;
}

static void source_add(Sources *sources, const char *archive)
{
    sources->archives[sources->n] = archive != NULL ? message_new("%s", archive) : NULL;
    sources->all[sources->n] =
        (StageSource){sources->folders[sources->n], sources->archives[sources->n]};
    sources->n++;
}

// Unpack an open archive, and add its folder. Returns 0, 1 when the archive is at fault, or -1.
static int archive_add(Sources *sources, const char *path, int file, const char *archive)
{
    char *said = NULL;
    const int outcome = archive_unpack(sources->workshop, sources->n_unpacked++, path, file,
                                       sources->folders[sources->n], &said);
    if (outcome == 0 && said != NULL && archive != NULL) {
        char shown[MESSAGE_SHOWN_BYTES];
        char *longer = message_new("%s: %s", message_show(archive, shown, sizeof shown), said);
        free(said);
        said = longer;
    }
    sources->said = messages_join(sources->said, said);
    if (outcome == 0) {
        source_add(sources, archive);
    }
    return outcome;
}

// ---- Folder or file -------------------------------------------------------------------------

static int is_of_lab(const Manifest *manifest, const char *name)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (name_match(name, manifest->files[i]) != NAME_OTHER) {
            return 1;
        }
    }
    return 0;
}

// The only entry of a folder: its name, or "" where there are others or none.
static void only_entry(DIR *folder, char *name, size_t n_bytes)
{
    int n_entries = 0;
    struct dirent *entry;
    name[0] = '\0';
    while (n_entries < 2 && (entry = readdir(folder)) != NULL) {
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            n_entries++;
            snprintf(name, n_bytes, "%s", entry->d_name);
        }
    }
    if (n_entries != 1) {
        name[0] = '\0';
    }
}

// Where a folder holds nothing but one regular file that is none of the lab's: that file, open, and
// its path for messages. Else -1.
static int only_file_open(const Manifest *manifest, const char *folder, char path[PATH_MAX])
{
    char name[NAME_MAX + 1];
    DIR *entries = opendir(folder);
    if (entries == NULL) {
        return -1;
    }
    only_entry(entries, name, sizeof name);
    int file = -1;
    struct stat status;
    if (name[0] != '\0' && !is_of_lab(manifest, name) &&
        fstatat(dirfd(entries), name, &status, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISREG(status.st_mode)) {
        file = openat(dirfd(entries), name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        path_make(path, "%s/%s", folder, name);
    }
    closedir(entries);
    return file;
}

// ---- Archives in a folder -------------------------------------------------------------------

// Is each of the lab's files in the folder itself? Returns 1 or 0, or -1 after one message.
static int folder_is_complete(const Manifest *manifest, const char *path)
{
    Places places[MANIFEST_MAX_FILES];
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0 ||
        places_find(folder, manifest->lab, manifest->files, manifest->n_files, places) != 0) {
        const int fault = errno;
        if (folder >= 0) {
            close(folder);
        }
        return machinery_fault(path, fault);
    }
    close(folder);
    int complete = 1;
    for (int i = 0; i < manifest->n_files; i++) {
        complete &= places[i].n_equal > 0 && places[i].rank < RANK_TOLD;
    }
    places_free(places, manifest->n_files);
    return complete;
}

static int is_archive(const struct dirent *entry)
{
    return entry->d_name[0] != '.' && is_archive_name(entry->d_name);
}

static int name_order(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

// Unpack an archive that lies in a folder. One that is at fault is told, and the others count.
// Returns 0, or -1 after one message.
static int inner_archive_add(Sources *sources, const char *path, const char *name)
{
    struct stat status;
    char inner[PATH_MAX];
    path_make(inner, "%s/%s", path, name);
    if (lstat(inner, &status) != 0 || !S_ISREG(status.st_mode)) {
        return 0;
    }
    const int file = open(inner, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
        return place_fault_is_ours(errno) ? machinery_fault(inner, errno) : 0;
    }
    const int outcome = archive_add(sources, inner, file, name);
    close(file);
    return outcome < 0 ? -1 : 0;
}

// Say of an archive that it was not unpacked.
static void unopened_say(Sources *sources, const char *name, const char *reason)
{
    char shown[MESSAGE_SHOWN_BYTES];
    char *said = message_new("%s: not opened: %s", message_show(name, shown, sizeof shown), reason);
    sources->said = messages_join(sources->said, said);
}

// Unpack the archives at a folder's top, in the order of their names, where a file is missing.
// Returns 0, or -1 after one message.
static int archives_add(Sources *sources, const char *path, int is_complete)
{
    struct dirent **entries;
    const int n = scandir(path, &entries, is_archive, name_order);
    int outcome = n >= 0 ? 0 : machinery_fault(path, errno);
    for (int i = 0; i < n; i++) {
        const char *name = entries[i]->d_name;
        if (outcome == 0 && i < SUBMISSION_MAX_ARCHIVES && is_complete) {
            unopened_say(sources, name, "each of the lab's files lies beside it, and counts");
        } else if (outcome == 0 && i < SUBMISSION_MAX_ARCHIVES) {
            outcome = inner_archive_add(sources, path, name);
        } else if (outcome == 0 && i == SUBMISSION_MAX_ARCHIVES) {
            unopened_say(sources, name, "there are too many archives, hand in only one");
        }
        free(entries[i]);
    }
    if (n >= 0) {
        free(entries);
    }
    return outcome;
}

// ---- All ------------------------------------------------------------------------------------

// Returns 0, 1 with a message, or -1.
static int folder_add(Sources *sources, const char *path)
{
    const Manifest *manifest = sources->workshop->manifest;
    char inner[PATH_MAX];
    const int file = only_file_open(manifest, path, inner);
    if (file >= 0) {
        const int outcome = archive_add(sources, inner, file, NULL);
        close(file);
        return outcome;
    }
    path_make(sources->folders[0], "%s", path);
    source_add(sources, NULL);
    const int complete = folder_is_complete(manifest, path);
    return complete >= 0 ? archives_add(sources, path, complete) : -1;
}

// Find or make the folders to stage from. Returns 0, 1 with a message, or -1.
static int sources_add(Sources *sources, const char *path)
{
    struct stat status;
    // O_NONBLOCK: a FIFO would otherwise wait for a writer that never comes.
    const int file = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    int outcome;
    if (file < 0 || fstat(file, &status) != 0) {
        outcome = machinery_fault(path, errno);
    } else if (S_ISDIR(status.st_mode)) {
        outcome = folder_add(sources, path);
    } else {
        outcome = archive_add(sources, path, file, NULL);
    }
    if (file >= 0) {
        close(file);
    }
    return outcome;
}

int submission_stage(const Workshop *workshop, const char *path, const char *destination,
                     char **message)
{
    Sources *sources = calloc(1, sizeof *sources);
    *message = NULL;
    if (sources == NULL) {
        return machinery_fault(path, ENOMEM);
    }
    sources->workshop = workshop;
    int outcome = sources_add(sources, path);
    if (outcome > 0) {
        outcome = STAGE_NOTHING;
    } else if (outcome == 0) {
        outcome =
            stage_submission(workshop->manifest, sources->all, sources->n, destination, message);
    }
    *message = messages_join(sources->said, *message);
    for (int i = 0; i < sources->n; i++) {
        free(sources->archives[i]);
    }
    free(sources);
    return outcome;
}
