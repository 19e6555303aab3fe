// All of a class's export out of an archive (see unpack.h).
//
// The files are written as they are read: together they may be larger than the memory. Read next:
// unpack_read.c, places.h.
#include "bytes_write.h"
#include "folder.h"
#include "message.h"
#include "places.h"
#include "unpack.h"
#include "unpack_read.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// An entry cannot be written as it is. Returns 1.
static int complain(const UnpackReading *reading, const char *path, const char *what)
{
    char shown[MESSAGE_SHOWN_BYTES];
    return unpack_complain(reading, "\"%s\" %s: %s", message_show(path, shown, sizeof shown), what,
                           reading->rules->if_damaged);
}

// Why a path could not be opened or made. Returns 1 with a message, or -1 with errno set when the
// folder is at fault.
static int complain_fault(const UnpackReading *reading, const char *path)
{
    switch (errno) {
    case EEXIST:
        return complain(reading, path, "is in the archive twice");
    case ENOTDIR:
    case ELOOP:
        return complain(reading, path, "is in the archive as a folder and as something else");
    case ENAMETOOLONG:
    case EILSEQ:
    case EINVAL:
        return complain(reading, path, "is a name that this machine does not take");
    default:
        return -1;
    }
}

// Copy an entry's content to a new file. Returns 0, 1 with a message, or -1 with errno set.
static int content_copy(const UnpackReading *reading, struct archive_entry *entry, const char *path,
                        int file)
{
    char block[1 << 16];
    la_ssize_t n;
    int64_t n_left = archive_entry_size(entry);
    while ((n = archive_read_data(reading->archive, block, sizeof block)) > 0) {
        n_left -= n;
        if (n_left < 0) {
            return complain(reading, path, "is larger than the archive says");
        }
        if (bytes_write(file, block, (size_t)n) != 0) {
            return -1;
        }
    }
    return n == 0 ? 0 : unpack_complain_damaged(reading);
}

static int file_unpack(const UnpackReading *reading, struct archive_entry *entry, const char *path,
                       int parent, const char *name)
{
    if (archive_entry_is_encrypted(entry)) {
        return unpack_complain_encrypted(reading);
    }
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int file = openat(parent, name, flags, 0644);
    if (file < 0) {
        return complain_fault(reading, path);
    }
    const int outcome = content_copy(reading, entry, path, file);
    if (outcome == 0) {
        time_set(file, archive_entry_mtime(entry));
    }
    return close_after(file, outcome);
}

// An entry that is no folder, in the open folder that it belongs to.
static int entry_write(const UnpackReading *reading, struct archive_entry *entry, const char *path,
                       int parent, const char *name)
{
    if (archive_entry_hardlink(entry) != NULL) {
        return complain(reading, path, "is the same file as another one");
    }
    if (archive_entry_filetype(entry) == AE_IFREG) {
        return file_unpack(reading, entry, path, parent, name);
    }
    return symlinkat("nowhere", parent, name) == 0 ? 0 : complain_fault(reading, path);
}

static int entry_unpack(const UnpackReading *reading, struct archive_entry *entry, int folder)
{
    const int is_folder = archive_entry_filetype(entry) == AE_IFDIR;
    const char *path = unpack_path_text(entry);
    UnpackPath parts;
    if (path == NULL) {
        return unpack_complain(reading, "a name in the archive is no text: %s",
                               reading->rules->if_damaged);
    }
    if (unpack_path_read(path, FOLDER_MAX_DEPTH - 1, &parts) != 0) {
        const int is_top = is_folder && path[strspn(path, "./")] == '\0';
        return is_top ? 0 : complain(reading, path, "is no path below a folder, or a long one");
    }
    const int parent = place_make(folder, parts.folder);
    if (parent < 0) {
        return complain_fault(reading, path);
    }
    int outcome = 0;
    if (!is_folder) {
        outcome = entry_write(reading, entry, path, parent, parts.name);
    } else {
        const int inner = place_make(parent, parts.name);
        outcome = inner < 0 ? complain_fault(reading, path) : close(inner);
    }
    return close_after(parent, outcome);
}

struct archive *unpack_export_reader_new(void)
{
    struct archive *archive = unpack_reader_new();
    // Behind a tar's end mark there may be another tar.
    if (archive != NULL &&
        archive_read_set_option(archive, "tar", "read_concatenated_archives", "1") != ARCHIVE_OK) {
        archive_read_free(archive);
        return NULL;
    }
    return archive;
}

// Does a tar end without its mark? It was cut off between two entries, then. Behind the last entry
// nothing was read but the mark.
static int is_cut_off(struct archive *archive)
{
    return (archive_format(archive) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_TAR &&
           archive_filter_bytes(archive, 0) == archive_read_header_position(archive);
}

int unpack_export(struct archive *archive, int folder, char *message)
{
    UnpackReading reading = {archive, &unpack_rules_export, message, 0, 0};
    struct archive_entry *entry;
    message[0] = '\0';
    int outcome = unpack_next(&reading, &entry);
    while (outcome == 0 && entry != NULL) {
        outcome = entry_unpack(&reading, entry, folder);
        if (outcome == 0) {
            outcome = unpack_next(&reading, &entry);
        }
    }
    if (outcome == 0 && is_cut_off(archive)) {
        archive_set_error(archive, EINVAL, "a tar archive without its end mark");
        outcome = unpack_complain_damaged(&reading);
    }
    return outcome;
}
