// Temporary folders; and measuring and removing folders that are not trusted (see folder.h).
//
// Every step opens one name in a folder that is held open and follows no link, so nothing that is
// swapped meanwhile leads elsewhere. Read next: sandbox_processes.c, which measures.
#include "folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int temporary_folder_make(char path[PATH_MAX], const char *name)
{
    const char *parent = getenv("TMPDIR");
    if (parent == NULL || parent[0] == '\0') {
        parent = "/tmp";
    }
    const int length = snprintf(path, PATH_MAX, "%s/%s-XXXXXX", parent, name);
    if (length < 0 || length >= PATH_MAX) {
        errno = ENAMETOOLONG;
    } else if (mkdtemp(path) != NULL) {
        return 0;
    }
    path[0] = '\0';
    return -1;
}

int folder_file_open(int folder, const char *name, size_t *n_bytes)
{
    const int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    struct stat status;
    // Opening alone may do something to a device: a tape winds, a watchdog wakes.
    if (fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    if (!S_ISREG(status.st_mode)) {
        errno = S_ISLNK(status.st_mode) ? ELOOP : ENXIO;
        return -1;
    }
    const int file = openat(folder, name, flags);
    // What has taken its place meanwhile is something else.
    if (file >= 0 && (fstat(file, &status) != 0 || !S_ISREG(status.st_mode))) {
        close(file);
        errno = ENXIO;
        return -1;
    }
    *n_bytes = (size_t)status.st_size;
    return file;
}

static DIR *folder_open(int parent, const char *name)
{
    int descriptor = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *folder = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    if (folder == NULL && descriptor >= 0) {
        close(descriptor);
    }
    return folder;
}

// The next entry but "." and "..".
static const struct dirent *entry_next(DIR *folder)
{
    const struct dirent *entry;
    do {
        entry = readdir(folder);
    } while (entry != NULL &&
             (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0));
    return entry;
}

static void level_measure(int parent, const char *name, int depth, long long n_files_most,
                          FolderSize *size)
{
    const int is_too_deep = depth >= FOLDER_MAX_DEPTH;
    DIR *folder = !is_too_deep ? folder_open(parent, name) : NULL;
    if (folder == NULL) {
        // Only now is errno about this folder. ENOENT: it was removed meanwhile.
        if (is_too_deep || errno != ENOENT) {
            size->n_files = n_files_most + 1;
        }
        return;
    }
    const struct dirent *entry;
    while (size->n_files <= n_files_most && (entry = entry_next(folder)) != NULL) {
        struct stat status;
        if (fstatat(dirfd(folder), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
            continue;
        }
        size->n_files++;
        size->n_bytes += (long long)status.st_blocks * 512;
        if (S_ISDIR(status.st_mode)) {
            level_measure(dirfd(folder), entry->d_name, depth + 1, n_files_most, size);
        }
    }
    closedir(folder);
}

void folder_measure(const char *path, long long n_files_most, FolderSize *size)
{
    level_measure(AT_FDCWD, path, 0, n_files_most, size);
}

// Move what a folder holds up into `top`, under names that are free there, and remove it: so that
// depth costs neither stack nor descriptors. Returns 0, or -1 with errno set.
static int level_flatten(int top, const char *name, unsigned long *n_moved)
{
    // Its owner may have closed it to itself.
    if (fchmodat(top, name, 0700, 0) != 0) {
        return -1;
    }
    DIR *folder = folder_open(top, name);
    if (folder == NULL) {
        return -1;
    }
    const struct dirent *entry;
    int result = 0;
    while (result == 0 && (entry = entry_next(folder)) != NULL) {
        if (unlinkat(dirfd(folder), entry->d_name, 0) == 0 ||
            unlinkat(dirfd(folder), entry->d_name, AT_REMOVEDIR) == 0) {
            continue;
        }
        // A folder that is closed to its owner cannot be moved either.
        if (fchmodat(dirfd(folder), entry->d_name, 0700, 0) != 0) {
            result = -1;
            break;
        }
        // What is replaced, if anything, is an empty folder, and to be removed as well: not every
        // file system knows RENAME_NOREPLACE.
        char moved[32];
        do {
            snprintf(moved, sizeof moved, "moved-%lu", (*n_moved)++);
            result = renameat(dirfd(folder), entry->d_name, top, moved);
        } while (result != 0 && (errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR));
    }
    closedir(folder);
    return result == 0 ? unlinkat(top, name, AT_REMOVEDIR) : -1;
}

// Remove what the folder `name` holds, and itself.
static int tree_remove(int parent, const char *name)
{
    unsigned long n_moved = 0;
    int result = 0, n_seen;
    do {
        DIR *top = folder_open(parent, name);
        if (top == NULL) {
            return -1;
        }
        n_seen = 0;
        const struct dirent *entry;
        while (result == 0 && (entry = entry_next(top)) != NULL) {
            n_seen++;
            if (unlinkat(dirfd(top), entry->d_name, 0) != 0 &&
                unlinkat(dirfd(top), entry->d_name, AT_REMOVEDIR) != 0) {
                result = level_flatten(dirfd(top), entry->d_name, &n_moved);
            }
        }
        closedir(top);
    } while (result == 0 && n_seen > 0);
    return result == 0 ? unlinkat(parent, name, AT_REMOVEDIR) : -1;
}

int folder_remove(const char *path)
{
    return tree_remove(AT_FDCWD, path);
}

// ---- What one user left where everybody may write ---------------------------------------------

// Do something with an entry of a folder.
typedef void EntryVisit(int folder, const char *name, const struct stat *status, void *context);

// What is looked for, and where.
typedef struct Search {
    uid_t owner;
    mode_t enters;  // folders of others that give everybody one of these rights
    EntryVisit *visit;
    void *context;
} Search;

// Visit what the owner has in a folder and those below. In one that is not open to everybody there
// is nothing, but there may be in a folder below.
static void owned_visit(int parent, const char *name, int depth, int is_open, const Search *search)
{
    DIR *folder = depth < FOLDER_MAX_DEPTH ? folder_open(parent, name) : NULL;
    const struct dirent *entry;
    while (folder != NULL && (entry = entry_next(folder)) != NULL) {
        const int may_be_folder = entry->d_type == DT_DIR || entry->d_type == DT_UNKNOWN;
        struct stat status;
        if ((!is_open && !may_be_folder) ||
            fstatat(dirfd(folder), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) {
            continue;
        }
        if (is_open && status.st_uid == search->owner) {
            search->visit(dirfd(folder), entry->d_name, &status, search->context);
        } else if (S_ISDIR(status.st_mode) && (status.st_mode & search->enters) != 0) {
            owned_visit(dirfd(folder), entry->d_name, depth + 1, (status.st_mode & S_IWOTH) != 0,
                        search);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

typedef struct Measuring {
    long long n_files_most;
    FolderSize *size;
} Measuring;

static void entry_measure(int folder, const char *name, const struct stat *status, void *context)
{
    const Measuring *measuring = context;
    FolderSize *size = measuring->size;
    if (size->n_files > measuring->n_files_most) {
        return;
    }
    size->n_files++;
    size->n_bytes += (long long)status->st_blocks * 512;
    if (S_ISDIR(status->st_mode)) {
        level_measure(folder, name, 1, measuring->n_files_most, size);
    }
}

void folder_measure_of(const char *path, uid_t owner, long long n_files_most, FolderSize *size)
{
    Measuring measuring = {n_files_most, size};
    const Search search = {owner, S_IWOTH, entry_measure, &measuring};
    owned_visit(AT_FDCWD, path, 0, 1, &search);
}

static void entry_remove(int folder, const char *name, const struct stat *status, void *context)
{
    (void)context;
    if (S_ISDIR(status->st_mode)) {
        fchmodat(folder, name, 0700, 0);
        tree_remove(folder, name);
    } else {
        unlinkat(folder, name, 0);
    }
}

void folder_remove_of(const char *path, uid_t owner)
{
    const Search search = {owner, S_IWOTH | S_IXOTH, entry_remove, NULL};
    owned_visit(AT_FDCWD, path, 0, 1, &search);
}
