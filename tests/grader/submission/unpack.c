// The lab's files out of an archive (see unpack.h).
//
// libarchive reads the formats; here is decided what of that is written, and how much. Read next:
// unpack_entry.c.
#include "unpack.h"

#include "places.h"
#include "stage.h"
#include "unpack_entry.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    switch (unpack_entry(unpacking->archive, entry, unpacking->folder, parts, n_parts,
                         unpacking->bytes)) {
    case 0:
        return 0;
    case ENTRY_DAMAGED:
        return complain_damaged(unpacking);
    case ENTRY_ENCRYPTED:
        return complain_encrypted(unpacking);
    default:
        return -1;
    }
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
