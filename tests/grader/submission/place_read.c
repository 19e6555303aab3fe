// Reading a file that a student handed in (see place_read.h).
#include "place_read.h"

#include "bytes_write.h"
#include "stage.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// Open a regular file in an open folder. Returns a descriptor, or -1 with errno set: ENXIO where it
// is something else.
static int regular_open(int parent, const char *file)
{
    struct stat status;
    if (fstatat(parent, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    // Opening alone may do something to a device: a tape winds, a watchdog wakes.
    if (!S_ISREG(status.st_mode)) {
        errno = S_ISLNK(status.st_mode) ? ELOOP : ENXIO;
        return -1;
    }
    // O_NONBLOCK: opening a FIFO that has taken its place meanwhile would wait for a writer that
    // never comes.
    return openat(parent, file, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

int place_file_open(int top, const Place *place)
{
    const int parent = place_open(top, place->folder);
    if (parent < 0) {
        return -1;
    }
    return close_after(parent, regular_open(parent, place->name));
}

ssize_t place_bytes_read(int descriptor, unsigned char *bytes)
{
    size_t n_read = 0;
    while (n_read <= STAGE_MAX_FILE_BYTES) {
        ssize_t n = read(descriptor, bytes + n_read, STAGE_MAX_FILE_BYTES + 1 - n_read);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n < 0) {
            return -1;
        }
        if (n == 0) {
            break;
        }
        n_read += (size_t)n;
    }
    return (ssize_t)n_read;
}

ssize_t place_text_read(int top, const Place *place, unsigned char *bytes, time_t *changed)
{
    struct stat status;
    const int descriptor = place_file_open(top, place);
    if (descriptor < 0) {
        return -1;
    }
    const int is_regular = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                           status.st_size <= STAGE_MAX_FILE_BYTES;
    const ssize_t n_read = is_regular ? place_bytes_read(descriptor, bytes) : -1;
    if (changed != NULL) {
        *changed = is_regular ? status.st_mtime : 0;
    }
    close(descriptor);
    return n_read;
}
