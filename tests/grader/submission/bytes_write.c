// Writing to open files (see bytes_write.h).
#include "bytes_write.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

int bytes_write(int descriptor, const void *bytes, size_t n_bytes)
{
    const unsigned char *next = bytes;
    const unsigned char *end = next + n_bytes;
    while (next < end) {
        const ssize_t n = write(descriptor, next, (size_t)(end - next));
        if (n >= 0) {
            next += n;
        } else if (errno != EINTR) {
            return -1;
        }
    }
    return 0;
}

void time_set(int descriptor, time_t changed)
{
    const struct timespec times[2] = {{.tv_nsec = UTIME_OMIT}, {.tv_sec = changed}};
    (void)!futimens(descriptor, times);
}

int close_after(int descriptor, int outcome)
{
    const int fault = errno;
    const int closed = close(descriptor);
    if (outcome == 0) {
        return closed;
    }
    errno = fault;
    return outcome;
}

// By writing, as what a disk says of itself is not what this user may fill.
int room_try(int folder, int n_megabytes)
{
    enum { BLOCKS_PER_MEGABYTE = 16 };
    static const char name[] = "room";
    static char block[(1 << 20) / BLOCKS_PER_MEGABYTE];
    const int descriptor = openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    int outcome = descriptor >= 0 ? 0 : -1;
    for (int i = 0; outcome == 0 && i < n_megabytes * BLOCKS_PER_MEGABYTE; i++) {
        outcome = bytes_write(descriptor, block, sizeof block);
    }
    if (descriptor >= 0) {
        outcome = close_after(descriptor, outcome);
        const int fault = errno;
        unlinkat(folder, name, 0);
        errno = fault;
    }
    return outcome;
}
