// A copy becomes a file (see unpack_write.h).
//
// Every step of a path is opened by itself and through no link, so that no copy can lead another
// one out of the folder.
#include "unpack_write.h"

#include "bytes_write.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Is it a fault of the disk? Else the copy itself cannot be written, and is passed over.
static int outcome_of(int fault)
{
    return fault == ENOSPC || fault == EDQUOT || fault == EIO || fault == EROFS ? -1 : 0;
}

void unpack_time_set(int descriptor, time_t changed)
{
    const struct timespec times[2] = {{.tv_nsec = UTIME_OMIT}, {.tv_sec = changed}};
    (void)!futimens(descriptor, times);
}

// Returns as copy_write() does.
static int file_write(const Copy *copy, int parent, const char *name)
{
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int descriptor = openat(parent, name, flags, 0644);
    if (descriptor < 0) {
        return outcome_of(errno);
    }
    int fault = bytes_write(descriptor, copy->bytes, copy->n_bytes) != 0 ? errno : 0;
    unpack_time_set(descriptor, copy->changed);  // of several archives the newest file counts
    if (close(descriptor) != 0 && fault == 0) {
        fault = errno;
    }
    errno = fault;
    return fault != 0 ? -1 : 0;
}

// Make the folder if it is not there, and open it. Returns a descriptor, or -1 with errno set.
// Closes `parent`.
static int folder_enter(int parent, const char *name)
{
    int inner = -1;
    if (mkdirat(parent, name, 0755) == 0 || errno == EEXIST) {
        inner = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    }
    const int fault = errno;
    close(parent);
    errno = fault;
    return inner;
}

int unpack_folder_open(int folder, const char *path)
{
    int inner = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (inner >= 0 && *path != '\0') {
        char name[NAME_MAX + 1];
        const size_t length = strcspn(path, "/");  // at most NAME_MAX, see unpack.c
        memcpy(name, path, length);
        name[length] = '\0';
        inner = folder_enter(inner, name);
        path += length + (path[length] == '/');
    }
    return inner;
}

int copy_write(const Copy *copy, int folder)
{
    const char *name = copy->place.name;
    const int parent = unpack_folder_open(folder, copy->place.folder);
    if (parent < 0) {
        return outcome_of(errno);
    }
    int outcome = 0;
    switch (copy->kind) {
    case COPY_OF_FILE:
        outcome = file_write(copy, parent, name);
        break;
    case COPY_OF_LINK:
        outcome = symlinkat("nowhere", parent, name) == 0 ? 0 : outcome_of(errno);
        break;
    case COPY_OF_OTHER:
        outcome = mkdirat(parent, name, 0755) == 0 ? 0 : outcome_of(errno);
        break;
    }
    const int fault = errno;
    close(parent);
    errno = fault;
    return outcome;
}
