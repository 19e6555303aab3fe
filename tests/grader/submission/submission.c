// Staging whatever was handed in (see submission.h).
//
// A folder is staged as it is. Where a file is not in it, or cannot be used, the archives at its
// top are unpacked, each to a folder of its own, and it is staged again. Read next: unpack_run.h,
// stage.h.
#include "submission.h"

#include "bytes_write.h"
#include "complain.h"
#include "contents.h"
#include "file_kind.h"
#include "file_names.h"
#include "folder.h"
#include "message.h"
#include "path.h"
#include "place_read.h"
#include "places.h"
#include "stage.h"
#include "unpack_run.h"
#include "workdir_files.h"

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
    const Workdir *workdir;
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
    const int outcome = archive_unpack(sources->workdir, sources->n_unpacked++, path, file,
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

// Is an open file an archive that is read here, whatever it is called?
static int is_packed(int file)
{
    enum { TAR_SIGN = 257 };
    unsigned char bytes[512];
    const ssize_t n = pread(file, bytes, sizeof bytes, 0);
    return n > 0 && (file_kind(bytes, (size_t)n).fault[0] != '\0' ||
                     (n == sizeof bytes && memcmp(bytes + TAR_SIGN, "ustar", 5) == 0));
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

// Where a folder holds nothing but one regular file that is none of the lab's, or an archive that
// is called like one: that file, open, and its path for messages. Else -1.
static int only_file_open(const Manifest *manifest, const char *folder, char path[PATH_MAX])
{
    char name[NAME_MAX + 1];
    DIR *entries = opendir(folder);
    if (entries == NULL) {
        return -1;
    }
    only_entry(entries, name, sizeof name);
    size_t n_bytes;
    const int file = name[0] != '\0' ? folder_file_open(dirfd(entries), name, &n_bytes) : -1;
    path_make(path, "%s/%s", folder, name);
    closedir(entries);
    if (file >= 0 && is_of_lab(manifest, name) && !is_packed(file)) {
        close(file);
        return -1;
    }
    return file;
}

// ---- Archives in a folder -------------------------------------------------------------------

static int is_archive(const struct dirent *entry)
{
    return entry->d_name[0] != '.' && archive_stem_length(entry->d_name) > 0;
}

static int name_order(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

// Unpack an archive that lies in a folder. One that is at fault is told, and the others count.
// Returns 0, or -1 after one message.
static int inner_archive_add(Sources *sources, const char *path, const char *name)
{
    size_t n_bytes;
    char inner[PATH_MAX];
    path_make(inner, "%s/%s", path, name);
    const int file = folder_file_open(AT_FDCWD, inner, &n_bytes);
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

// Unpack the archives at a folder's top, in the order of their names, or say that none was needed.
// Returns 0, or -1 after one message.
static int archives_add(Sources *sources, const char *path, int are_needed)
{
    struct dirent **entries;
    const int n = scandir(path, &entries, is_archive, name_order);
    int outcome = n >= 0 ? 0 : machinery_fault(path, errno);
    for (int i = 0; i < n; i++) {
        const char *name = entries[i]->d_name;
        if (outcome == 0 && i < SUBMISSION_MAX_ARCHIVES && !are_needed) {
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

// Stage from all there is until now. Returns as submission_stage() does.
static int sources_stage(const Sources *sources, const char *destination, char **message)
{
    free(*message);
    return stage_submission(sources->workdir->manifest, sources->all, sources->n, destination,
                            message);
}

// Returns as submission_stage() does.
static int folder_stage(Sources *sources, const char *path, const char *destination, char **message)
{
    path_make(sources->folders[0], "%s", path);
    source_add(sources, NULL);
    const int outcome = sources_stage(sources, destination, message);
    if (outcome < 0 || archives_add(sources, path, outcome > 0) != 0) {
        return -1;
    }
    return sources->n > 1 ? sources_stage(sources, destination, message) : outcome;
}

// Returns as submission_stage() does.
static int archive_stage(Sources *sources, const char *path, int file, const char *destination,
                         char **message)
{
    const int outcome = archive_add(sources, path, file, NULL);
    return outcome == 0  ? sources_stage(sources, destination, message)
           : outcome > 0 ? STAGE_NOTHING
                         : -1;
}

// Copy an open file as far as staging has to see it. Returns 0, or -1 after one message.
static int single_file_copy(int from, const char *to)
{
    unsigned char *bytes = malloc(STAGE_MAX_FILE_BYTES + 1);
    const ssize_t n = bytes != NULL ? place_bytes_read(from, bytes) : -1;
    const int out = n >= 0 ? open(to, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644) : -1;
    const int fault =
        out < 0 || close_after(out, bytes_write(out, bytes, (size_t)n)) != 0 ? errno : 0;
    free(bytes);
    return fault == 0 ? 0 : machinery_fault(to, fault);
}

// One of the lab's files by itself, as if a folder held it. Returns as submission_stage() does.
static int single_file_stage(Sources *sources, const char *path, int file, const char *destination,
                             char **message)
{
    char folder[PATH_MAX], copy[PATH_MAX];
    path_make(folder, "%s/single", sources->workdir->folder);
    path_make(copy, "%s/%s", folder, strrchr(path, '/') + 1);
    return make_folder(folder) == 0 && single_file_copy(file, copy) == 0
               ? folder_stage(sources, folder, destination, message)
               : -1;
}

// Stage what was handed in, which is open. Returns as submission_stage() does.
static int handed_in_stage(Sources *sources, const char *path, int file, const char *destination,
                           char **message)
{
    const Manifest *manifest = sources->workdir->manifest;
    char inner[PATH_MAX];
    struct stat status;
    if (fstat(file, &status) != 0) {
        return machinery_fault(path, errno);
    }
    // A class's links have other names than what they lead to.
    if (!S_ISDIR(status.st_mode) && realpath(path, inner) == NULL) {
        return machinery_fault(path, errno);
    }
    if (S_ISREG(status.st_mode) && is_of_lab(manifest, strrchr(inner, '/') + 1) &&
        !is_packed(file)) {
        return single_file_stage(sources, inner, file, destination, message);
    }
    if (!S_ISDIR(status.st_mode)) {
        return archive_stage(sources, inner, file, destination, message);
    }
    const int only_file = only_file_open(manifest, path, inner);
    if (only_file < 0) {
        return folder_stage(sources, path, destination, message);
    }
    const int outcome = archive_stage(sources, inner, only_file, destination, message);
    close(only_file);
    return outcome;
}

int submission_stage(const Workdir *workdir, const char *path, const char *destination,
                     char **message)
{
    *message = NULL;
    Sources *sources = calloc(1, sizeof *sources);
    if (sources == NULL) {
        return machinery_fault(path, ENOMEM);
    }
    sources->workdir = workdir;
    // O_NONBLOCK: a FIFO would otherwise wait for a writer that never comes.
    const int file = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    const int outcome = file >= 0 ? handed_in_stage(sources, path, file, destination, message)
                                  : machinery_fault(path, errno);
    if (file >= 0) {
        close(file);
    }
    *message = messages_join(sources->said, *message);
    for (int i = 0; i < sources->n; i++) {
        free(sources->archives[i]);
    }
    free(sources);
    return outcome;
}
