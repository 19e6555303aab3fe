// The lab's files out of an archive (see unpack.h).
//
// Flow: archive -> UNPACKED in the sandbox -> places -> staged. libarchive reads the formats; here
// is decided what of that is written, where, and how much.
#include "unpack.h"

#include "places.h"
#include "stage.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Unpacking {
    struct archive *archive;
    int folder;
    char *const *names;
    int n_names;
    int n_entries, n_files;
    int64_t n_bytes;       // of all entries, unpacked
    int is_office;         // a document of an office program, which is a zip archive, too
    char inner[64];        // the name of an archive in it, or ""
    char *message;         // [UNPACK_MESSAGE_BYTES]
    unsigned char *bytes;  // [STAGE_MAX_FILE_BYTES + 1] the file under way
} Unpacking;

struct archive *unpack_reader_new(void)
{
    struct archive *archive = archive_read_new();
    if (archive == NULL) {
        return NULL;
    }
    // The zip reader that starts from the directory at the end: one that is cut off is refused.
    if (archive_read_support_format_zip_seekable(archive) != ARCHIVE_OK ||
        archive_read_support_format_tar(archive) != ARCHIVE_OK ||
        archive_read_support_filter_gzip(archive) != ARCHIVE_OK ||
        archive_read_support_filter_bzip2(archive) != ARCHIVE_OK ||
        archive_read_support_filter_xz(archive) != ARCHIVE_OK) {
        archive_read_free(archive);
        return NULL;
    }
    return archive;
}

// ---- Faults of the archive ------------------------------------------------------------------

static int complain(const Unpacking *unpacking, const char *complaint)
{
    snprintf(unpacking->message, UNPACK_MESSAGE_BYTES, "%s", complaint);
    return 1;
}

static int complain_encrypted(const Unpacking *unpacking)
{
    return complain(unpacking, "the archive is encrypted: hand it in without a password");
}

// libarchive could not go on.
static int complain_damaged(const Unpacking *unpacking)
{
    const char *reason = archive_error_string(unpacking->archive);
    if (archive_errno(unpacking->archive) == ENOMEM) {
        reason = "reading it takes too much memory";
    }
    snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
             "the archive is damaged or cut off (%.120s): pack the files anew",
             reason != NULL ? reason : "for no known reason");
    return 1;
}

// Count an entry. Returns 0, or 1 when they are too many or too large.
static int entry_count(Unpacking *unpacking, struct archive_entry *entry)
{
    const int64_t most = (int64_t)UNPACK_MAX_MEGABYTES << 20;
    const int64_t n_bytes = archive_entry_size(entry);
    if (++unpacking->n_entries > UNPACK_MAX_ENTRIES) {
        snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
                 "the archive holds more than %d files: hand in the lab's files only",
                 UNPACK_MAX_ENTRIES);
        return 1;
    }
    if (n_bytes < 0 || n_bytes > most - unpacking->n_bytes) {
        snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
                 "the archive holds more than %d MB, unpacked: hand in the lab's files only",
                 UNPACK_MAX_MEGABYTES);
        return 1;
    }
    unpacking->n_bytes += n_bytes;
    return 0;
}

// ---- Writing --------------------------------------------------------------------------------

// Is it a fault of the disk? Else the entry itself cannot be written (its name is too long or no
// text that the file system takes, or another entry is in its way) and is passed over.
static int outcome_of(int fault)
{
    return fault == ENOSPC || fault == EDQUOT || fault == EIO || fault == EROFS ? -1 : 0;
}

static int bytes_write(int descriptor, const unsigned char *bytes, size_t n_bytes)
{
    while (n_bytes > 0) {
        const ssize_t n = write(descriptor, bytes, n_bytes);
        if (n < 0 && errno != EINTR) {
            return -1;
        }
        bytes += n > 0 ? n : 0;
        n_bytes -= n > 0 ? (size_t)n : 0;
    }
    return 0;
}

// Read an entry's content and write it. Returns as unpack() does.
static int file_write(Unpacking *unpacking, struct archive_entry *entry, int parent,
                      const char *name)
{
    if (archive_entry_is_encrypted(entry)) {
        return complain_encrypted(unpacking);
    }
    size_t n_bytes = 0;
    while (n_bytes <= STAGE_MAX_FILE_BYTES) {
        const la_ssize_t n = archive_read_data(unpacking->archive, unpacking->bytes + n_bytes,
                                               STAGE_MAX_FILE_BYTES + 1 - n_bytes);
        if (n < 0) {  // ARCHIVE_RETRY, too: it may be said without end
            return complain_damaged(unpacking);
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
    int fault = bytes_write(descriptor, unpacking->bytes, n_bytes) != 0 ? errno : 0;
    if (close(descriptor) != 0 && fault == 0) {
        fault = errno;
    }
    errno = fault;
    return fault != 0 ? -1 : 0;
}

static int entry_write(Unpacking *unpacking, struct archive_entry *entry, int parent,
                       const char *name)
{
    // Of several entries with one path the last one counts, as when tar appends a newer file.
    unlinkat(parent, name, 0);
    if (archive_entry_hardlink(entry) != NULL || archive_entry_filetype(entry) == AE_IFLNK) {
        return symlinkat("nowhere", parent, name) == 0 ? 0 : outcome_of(errno);
    }
    if (archive_entry_filetype(entry) != AE_IFREG) {
        return mkdirat(parent, name, 0755) == 0 ? 0 : outcome_of(errno);
    }
    return file_write(unpacking, entry, parent, name);
}

// ---- Paths ----------------------------------------------------------------------------------

// Cut a path at its slashes, in place, into at most PLACES_MAX_DEPTH + 1 parts. Returns how many it
// has, without empty ones and ".", or 0 for a path that is to be passed over.
static int path_split(char *path, char **parts)
{
    int n_parts = 0;
    for (char *part = path; part != NULL;) {
        char *slash = strchr(part, '/');
        if (slash != NULL) {
            *slash = '\0';
        }
        if (strcmp(part, "..") == 0 || n_parts > PLACES_MAX_DEPTH) {
            return 0;
        }
        if (part[0] != '\0' && strcmp(part, ".") != 0) {
            parts[n_parts++] = part;
        }
        part = slash != NULL ? slash + 1 : NULL;
    }
    return n_parts;
}

static int is_wanted(const Unpacking *unpacking, const char *name)
{
    for (int i = 0; i < unpacking->n_names; i++) {
        if (strcmp(name, unpacking->names[i]) == 0) {
            return 1;
        }
    }
    return 0;
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

// Write the entry where its path says. Returns as unpack() does.
static int entry_place(Unpacking *unpacking, struct archive_entry *entry, char *path)
{
    char *parts[PLACES_MAX_DEPTH + 1];
    const int n_parts = path_split(path, parts);
    if (n_parts == 0 || !is_wanted(unpacking, parts[n_parts - 1])) {
        return 0;
    }
    if (++unpacking->n_files > UNPACK_MAX_FILES) {
        snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
                 "the archive holds %s and the like more than %d times: hand in each file once",
                 parts[n_parts - 1], UNPACK_MAX_FILES);
        return 1;
    }
    int parent = openat(unpacking->folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (int i = 0; parent >= 0 && i < n_parts - 1; i++) {
        parent = folder_enter(parent, parts[i]);
    }
    if (parent < 0) {
        return outcome_of(errno);
    }
    const int outcome = entry_write(unpacking, entry, parent, parts[n_parts - 1]);
    const int fault = errno;
    close(parent);
    errno = fault;
    return outcome;
}

// ---- The archive ----------------------------------------------------------------------------

// Note what may explain that none of the wanted files is there.
static void contents_note(Unpacking *unpacking, const char *path)
{
    static const char *const endings[] = {".zip", ".tar", ".gz", ".tgz",
                                          ".bz2", ".xz",  ".7z", ".rar"};
    const size_t n_path = strlen(path);
    if (strcmp(path, "[Content_Types].xml") == 0 || strcmp(path, "META-INF/manifest.xml") == 0) {
        unpacking->is_office = 1;
    }
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        const size_t n_ending = strlen(endings[i]);
        if (n_path > n_ending && strcmp(path + n_path - n_ending, endings[i]) == 0) {
            const char *slash = strrchr(path, '/');
            snprintf(unpacking->inner, sizeof unpacking->inner, "%s",
                     slash != NULL ? slash + 1 : path);
        }
    }
}

static int complain_nothing(const Unpacking *unpacking)
{
    if (unpacking->is_office) {
        return complain(unpacking, "found an office program's document: hand in the source files "
                                   "themselves, in a folder or a zip or tar archive");
    }
    snprintf(
        unpacking->message, UNPACK_MESSAGE_BYTES,
        "the archive holds another one, %s, and none of the lab's files: hand in the inner one",
        unpacking->inner);
    return 1;
}

static int entry_unpack(Unpacking *unpacking, struct archive_entry *entry)
{
    if (entry_count(unpacking, entry) != 0) {
        return 1;
    }
    // NULL: a name that is no text in this locale; then libarchive may still know it as UTF-8.
    const char *path = archive_entry_pathname(entry);
    path = path != NULL ? path : archive_entry_pathname_utf8(entry);
    if (path == NULL) {
        return 0;
    }
    contents_note(unpacking, path);
    char *copy = strdup(path);
    if (copy == NULL) {
        return -1;
    }
    const int outcome = entry_place(unpacking, entry, copy);
    const int fault = errno;
    free(copy);
    errno = fault;
    return outcome;
}

static int entries_unpack(Unpacking *unpacking)
{
    struct archive_entry *entry;
    int outcome = 0;
    while (outcome == 0) {
        const int status = archive_read_next_header(unpacking->archive, &entry);
        if (status == ARCHIVE_EOF) {
            break;
        }
        if (status != ARCHIVE_OK && archive_format(unpacking->archive) == 0) {
            return UNPACK_NO_ARCHIVE;
        }
        if (status != ARCHIVE_OK && status != ARCHIVE_WARN) {
            return archive_read_has_encrypted_entries(unpacking->archive) > 0
                       ? complain_encrypted(unpacking)
                       : complain_damaged(unpacking);
        }
        outcome = entry_unpack(unpacking, entry);
    }
    if (outcome == 0 && unpacking->n_files == 0 &&
        (unpacking->is_office || unpacking->inner[0] != '\0')) {
        return complain_nothing(unpacking);
    }
    return outcome;
}

int unpack(struct archive *archive, int folder, char *const *names, int n_names, char *message)
{
    Unpacking unpacking = {.archive = archive,
                           .folder = folder,
                           .names = names,
                           .n_names = n_names,
                           .message = message,
                           .bytes = malloc(STAGE_MAX_FILE_BYTES + 1)};
    message[0] = '\0';
    if (unpacking.bytes == NULL) {
        return -1;
    }
    const int outcome = entries_unpack(&unpacking);
    const int fault = errno;
    free(unpacking.bytes);
    errno = fault;
    return outcome;
}

// ---- What is no archive ---------------------------------------------------------------------

const char *unpack_kind(const unsigned char *bytes, size_t n_bytes)
{
    static const struct {
        const char *start, *kind;
    } kinds[] = {
        {"PK\x03\x04", "a zip archive that is damaged or cut off"},
        {"Rar!", "a RAR archive"},
        {"7z\xBC\xAF", "a 7-Zip archive"},
        {"\x1F\x8B", "a compressed file (gzip) that is cut off or no tar archive"},
        {"BZh", "a compressed file (bzip2) that is cut off or no tar archive"},
        {"\xFD"
         "7zXZ",
         "a compressed file (xz) that is cut off or no tar archive"},
        {"\x28\xB5\x2F\xFD", "a compressed file (zstd)"},
        {"%PDF", "a PDF document"},
        {"\xD0\xCF\x11\xE0", "an office program's document"},
        {"\x7F"
         "ELF",
         "a compiled program"},
        {"\x89PNG", "a picture"},
        {"\xFF\xD8\xFF", "a picture"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const size_t n_start = strlen(kinds[i].start);
        if (n_bytes >= n_start && memcmp(bytes, kinds[i].start, n_start) == 0) {
            return kinds[i].kind;
        }
    }
    if (n_bytes == 0) {
        return "an empty file";
    }
    return memchr(bytes, '\0', n_bytes) == NULL ? "a single text file" : "a file of unknown kind";
}
