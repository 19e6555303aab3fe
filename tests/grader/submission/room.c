// Trying whether there is room (see room.h): by writing, as what a disk says of itself is not what
// this user may fill.
#include "room.h"

#include "bytes_write.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

int room_try(int folder, int n_megabytes)
{
    enum { BLOCKS_PER_MEGABYTE = 16 };
    static const char name[] = "room";
    static char block[(1 << 20) / BLOCKS_PER_MEGABYTE];
    const int descriptor = openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0) {
        return -1;
    }
    int fault = 0;
    for (int i = 0; fault == 0 && i < n_megabytes * BLOCKS_PER_MEGABYTE; i++) {
        fault = bytes_write(descriptor, block, sizeof block) != 0 ? errno : 0;
    }
    if (close(descriptor) != 0 && fault == 0) {
        fault = errno;
    }
    unlinkat(folder, name, 0);
    errno = fault;
    return fault == 0 ? 0 : -1;
}
