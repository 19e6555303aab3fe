// Temporary folders; and folders that somebody else has filled, with whatever names, depth and
// links: measured and emptied without ever leaving them.
#ifndef GRADER_FOLDER_H
#define GRADER_FOLDER_H

#include <limits.h>
#include <stddef.h>
#include <sys/types.h>

// Make a folder "NAME-" and six random characters in $TMPDIR, or in /tmp when that is unset or
// empty, and put its path into `path`. Returns 0, or -1 with errno set and `path` empty.
int temporary_folder_make(char path[PATH_MAX], const char *name);

typedef struct FolderSize {
    long long n_bytes;  // that its files take on the disk
    long long n_files;  // folders and links included
} FolderSize;

// Add what is below `path` to *size; stop once it holds more than n_files_most. What is nested
// deeper than FOLDER_MAX_DEPTH, or may not be looked into, counts as more than n_files_most.
enum { FOLDER_MAX_DEPTH = 40 };
void folder_measure(const char *path, long long n_files_most, FolderSize *size);

// The same for what belongs to `owner` in a folder where everybody may leave something, and in the
// folders below that are open to everybody, too. What lies in the owner's folders counts as well.
void folder_measure_of(const char *path, uid_t owner, long long n_files_most, FolderSize *size);

// Remove that, which nobody may be changing any more; and what lies in open folders that everybody
// reaches through others that are not: measuring as often as is needed would take too long there.
void folder_remove_of(const char *path, uid_t owner);

// Open a regular file to be read: no link is followed, and no FIFO waited for. Returns a
// descriptor, or -1 with errno set: ELOOP where it is a link, ENXIO where it is something else.
//   folder    open, or AT_FDCWD
//   n_bytes   out: its size
int folder_file_open(int folder, const char *name, size_t *n_bytes);

// Remove a folder and all that is in it, to any depth. Returns 0, or -1 with errno set.
int folder_remove(const char *path);

#endif
