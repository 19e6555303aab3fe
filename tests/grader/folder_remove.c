// Removing a folder that somebody else filled (see folder_remove.h).
//
// Flow: staged -> compiled -> run -> judged -> CLEARED AWAY. Walking down would need a path, a
// descriptor or a stack frame a level, and a student's program may have made any number of levels.
// So folders are pulled up instead: whatever folder is found in a folder moves to the top, until
// there is only one level left. Read next: workshop.c.
#include "folder_remove.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Open a folder to read it. Locked ones get unlocked, which their owner may do.
static DIR *entries_open(int parent, const char *name)
{
    // Through a descriptor of the folder itself, so that no link is followed.
    fchmodat(parent, name, 0700, AT_SYMLINK_NOFOLLOW);
    const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    return folder >= 0 ? fdopendir(folder) : NULL;
}

// The next entry but "." and "..", or NULL.
static const char *entry_next(DIR *entries)
{
    const struct dirent *entry;
    do {
        entry = readdir(entries);
    } while (entry != NULL &&
             (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0));
    return entry ? entry->d_name : NULL;
}

// Move folder `name` to the top under a name that is free there.
static int pull_up(int folder, const char *name, int top, unsigned *n_pulled)
{
    char free_name[32];
    fchmodat(folder, name, 0700, AT_SYMLINK_NOFOLLOW);
    int result;
    do {
        snprintf(free_name, sizeof free_name, "pulled-up-%u", (*n_pulled)++);
        result = renameat(folder, name, top, free_name);
    } while (result != 0 && (errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR));
    return result;
}

// Remove one folder of the top level: its files, and itself once its folders have been pulled up.
static int level_remove(int top, const char *name, unsigned *n_pulled)
{
    DIR *entries = entries_open(top, name);
    if (entries == NULL) {
        return -1;
    }
    int result = 0;
    const char *entry;
    while (result == 0 && (entry = entry_next(entries)) != NULL) {
        result = unlinkat(dirfd(entries), entry, 0);
        if (result != 0 && errno == EISDIR) {
            result = pull_up(dirfd(entries), entry, top, n_pulled);
        }
    }
    const int fault = errno;
    closedir(entries);
    errno = fault;
    return result == 0 ? unlinkat(top, name, AT_REMOVEDIR) : -1;
}

int folder_remove(const char *path)
{
    DIR *entries = entries_open(AT_FDCWD, path);
    if (entries == NULL) {
        return errno == ENOENT ? 0 : -1;
    }
    unsigned n_pulled = 0;
    int result = 0;
    int n_found = 1;
    // What was pulled up while the level was read is found in the next round.
    while (result == 0 && n_found > 0) {
        const char *entry;
        n_found = 0;
        rewinddir(entries);
        while (result == 0 && (entry = entry_next(entries)) != NULL) {
            n_found++;
            result = unlinkat(dirfd(entries), entry, 0);
            if (result != 0 && errno == EISDIR) {
                result = level_remove(dirfd(entries), entry, &n_pulled);
            }
        }
    }
    const int fault = errno;
    closedir(entries);
    errno = fault;
    return result == 0 ? rmdir(path) : -1;
}
