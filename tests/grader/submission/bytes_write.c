// Writing bytes to an open file, all of them: write() may take a part, or be interrupted.
#include "bytes_write.h"

#include <errno.h>
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
