// Closing ranges of descriptors (see descriptors.h).
#include "descriptors.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

// Close what /proc lists. Closing while listing may skip an entry: hence once more, until there is
// none.
static int listed_close(int first, int last)
{
    int n_closed;
    do {
        DIR *folder = opendir("/proc/self/fd");
        if (folder == NULL) {
            return -1;
        }
        n_closed = 0;
        const struct dirent *entry;
        while ((entry = readdir(folder)) != NULL) {
            const int descriptor = atoi(entry->d_name);  // 0 of "." and ".."
            if (entry->d_name[0] != '.' && descriptor >= first && descriptor <= last &&
                descriptor != dirfd(folder)) {
                n_closed += close(descriptor) == 0;
            }
        }
        closedir(folder);
    } while (n_closed > 0);
    return 0;
}

int descriptors_close(int first, int last)
{
    if (first > last || close_range((unsigned)first, (unsigned)last, 0) == 0) {
        return 0;
    }
    // Linux before 5.9 does not know the call, and gVisor not for every range.
    return errno == ENOSYS || errno == EINVAL || errno == EPERM ? listed_close(first, last) : -1;
}
