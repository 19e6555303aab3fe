// One entry of an archive becomes a file (see unpack_entry.h).
//
// Every step of a path is opened by itself and through no link, so that no earlier entry can lead a
// later one out of the folder.
#include "unpack_entry.h"

#include "bytes_write.h"
#include "stage.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// Is it a fault of the disk? Else the entry itself cannot be written (its name is too long or no
// text that the file system takes, or another entry is in its way) and is passed over.
static int outcome_of(int fault)
{
    return fault == ENOSPC || fault == EDQUOT || fault == EIO || fault == EROFS ? -1 : 0;
}

// Read an entry's content and write it. Returns as unpack_entry() does.
static int file_write(struct archive *archive, struct archive_entry *entry, int parent,
                      const char *name, unsigned char *bytes)
{
    if (archive_entry_is_encrypted(entry)) {
        return ENTRY_ENCRYPTED;
    }
    size_t n_bytes = 0;
    while (n_bytes <= STAGE_MAX_FILE_BYTES) {
        const la_ssize_t n =
            archive_read_data(archive, bytes + n_bytes, STAGE_MAX_FILE_BYTES + 1 - n_bytes);
        if (n < 0) {  // ARCHIVE_RETRY, too: it may be said without end
            return ENTRY_DAMAGED;
        }
        if (n == 0) {
            break;
        }
        n_bytes += (size_t)n;
    }
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int descriptor = openat(parent, name, flags, 0644);
    if (descriptor < 0) {
        return outcome_of(errno);
    }
    int fault = bytes_write(descriptor, bytes, n_bytes) != 0 ? errno : 0;
    if (close(descriptor) != 0 && fault == 0) {
        fault = errno;
    }
    errno = fault;
    return fault != 0 ? -1 : 0;
}

static int entry_write(struct archive *archive, struct archive_entry *entry, int parent,
                       const char *name, unsigned char *bytes)
{
    // Of several entries with one path the last one counts, as when tar appends a newer file.
    unlinkat(parent, name, 0);
    if (archive_entry_hardlink(entry) != NULL || archive_entry_filetype(entry) == AE_IFLNK) {
        return symlinkat("nowhere", parent, name) == 0 ? 0 : outcome_of(errno);
    }
    if (archive_entry_filetype(entry) != AE_IFREG) {
        return mkdirat(parent, name, 0755) == 0 ? 0 : outcome_of(errno);
    }
    return file_write(archive, entry, parent, name, bytes);
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

int unpack_entry(struct archive *archive, struct archive_entry *entry, int folder,
                 char *const *parts, int n_parts, unsigned char *bytes)
{
    int parent = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (int i = 0; parent >= 0 && i < n_parts - 1; i++) {
        parent = folder_enter(parent, parts[i]);
    }
    if (parent < 0) {
        return outcome_of(errno);
    }
    const int outcome = entry_write(archive, entry, parent, parts[n_parts - 1], bytes);
    const int fault = errno;
    close(parent);
    errno = fault;
    return outcome;
}
