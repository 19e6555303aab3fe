// Reading a file that a student handed in (see place_read.h).
#include "place_read.h"

#include "bytes_write.h"
#include "folder.h"
#include "stage.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

int place_file_open(int top, const Place *place)
{
    size_t n_bytes;
    const int parent = place_open(top, place->folder);
    if (parent < 0) {
        return -1;
    }
    return close_after(parent, folder_file_open(parent, place->name, &n_bytes));
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
