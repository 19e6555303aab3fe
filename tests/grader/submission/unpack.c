// The lab's files out of an archive (see unpack.h).
//
// libarchive reads the formats; here is decided what of that is read, and how much. Whatever else
// an archive uses up is its own fault, too: memory here, time and the rest where the program is
// started (unpack_run.c). Read next: copies.h, unpack_write.c.
#include "unpack.h"

#include "contents.h"
#include "copies.h"
#include "message.h"
#include "stage.h"
#include "unpack_write.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Unpacking {
    struct archive *archive;
    const Manifest *manifest;
    int n_entries;
    int n_files, n_told;  // entries of wanted files, and those whose name or folder is only told
    int64_t n_bytes;      // of all entries, unpacked
    Contents contents;
    char *message;         // [UNPACK_MESSAGE_BYTES]
    unsigned char *bytes;  // [STAGE_MAX_FILE_BYTES + 1] the file under way
    Copies files[MANIFEST_MAX_FILES];
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

static int complain_memory(const Unpacking *unpacking)
{
    return complain(unpacking, "reading the archive takes too much memory: pack the files anew");
}

// libarchive could not go on.
static int complain_damaged(const Unpacking *unpacking)
{
    if (archive_errno(unpacking->archive) == ENOMEM) {
        return complain_memory(unpacking);
    }
    const char *reason = archive_error_string(unpacking->archive);
    snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
             "the archive is damaged or cut off (%.120s): pack the files anew",
             reason != NULL ? reason : "for no known reason");
    return 1;
}

// Each layer may ask for its own tens of megabytes. Returns 0, or 1 where there are too many.
static int layers_count(const Unpacking *unpacking)
{
    const int n_layers = archive_filter_count(unpacking->archive) - 1;  // the file itself is one
    if (n_layers > UNPACK_MAX_LAYERS) {
        snprintf(
            unpacking->message, UNPACK_MESSAGE_BYTES,
            "the archive is compressed %d times over, expected at most %d: pack the files anew",
            n_layers, UNPACK_MAX_LAYERS);
    }
    return n_layers > UNPACK_MAX_LAYERS;
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

typedef struct Path {
    char folder[PLACES_MAX_DEPTH * (NAME_MAX + 1)];  // "" is the top
    char name[NAME_MAX + 1];
} Path;

// Take a path apart, without what says nothing in it: "/", "." and what is empty. Returns 0, or -1
// for one that is to be passed over.
static int path_read(const char *text, Path *path)
{
    int n_folders = 0;
    char *end = path->folder;
    *end = path->name[0] = '\0';
    while (*text != '\0') {
        const char *part = text;
        const size_t length = strcspn(part, "/");
        text += length + (text[length] == '/');
        if (length == 0 || (length == 1 && part[0] == '.')) {
            continue;
        }
        if (length > NAME_MAX || (length == 2 && part[0] == '.' && part[1] == '.')) {
            return -1;
        }
        if (path->name[0] != '\0') {
            if (n_folders++ == PLACES_MAX_DEPTH) {
                return -1;
            }
            end += sprintf(end, "%s%s", n_folders > 1 ? "/" : "", path->name);
        }
        memcpy(path->name, part, length);
        path->name[length] = '\0';
    }
    return path->name[0] != '\0' ? 0 : -1;
}

// ---- Entries --------------------------------------------------------------------------------

// Read an entry's content. Returns 0, or 1 with a message.
static int content_read(Unpacking *unpacking, struct archive_entry *entry, size_t *n_bytes)
{
    if (archive_entry_is_encrypted(entry)) {
        return complain_encrypted(unpacking);
    }
    *n_bytes = 0;
    while (*n_bytes <= STAGE_MAX_FILE_BYTES) {
        const la_ssize_t n = archive_read_data(unpacking->archive, unpacking->bytes + *n_bytes,
                                               STAGE_MAX_FILE_BYTES + 1 - *n_bytes);
        if (n < 0) {  // ARCHIVE_RETRY, too: it may be said without end
            return complain_damaged(unpacking);
        }
        if (n == 0) {
            break;
        }
        *n_bytes += (size_t)n;
    }
    return 0;
}

static CopyKind kind_of(struct archive_entry *entry)
{
    return archive_entry_hardlink(entry) != NULL || archive_entry_filetype(entry) == AE_IFLNK
               ? COPY_OF_LINK
           : archive_entry_filetype(entry) == AE_IFREG ? COPY_OF_FILE
                                                       : COPY_OF_OTHER;
}

// Keep the entry of a wanted file, where it is one that counts until now. Returns 0, or 1 with a
// message.
static int entry_keep(Unpacking *unpacking, struct archive_entry *entry, const Place *place,
                      int rank, Copies *file)
{
    const int is_told_only = rank >= RANK_TOLD;
    const CopyKind kind = is_told_only ? COPY_OF_FILE : kind_of(entry);
    size_t n_bytes = 0;
    Copy *copy;
    unpacking->n_files += !is_told_only;
    unpacking->n_told += is_told_only;
    if (unpacking->n_files > UNPACK_MAX_FILES) {
        snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
                 "the archive holds %s and the like more than %d times: hand in each file once",
                 file->name, UNPACK_MAX_FILES);
        return 1;
    }
    if (copies_find(file, place, rank, &copy) != 0) {
        return complain_memory(unpacking);
    }
    if (copy == NULL) {
        return 0;
    }
    if (kind == COPY_OF_FILE && !is_told_only && content_read(unpacking, entry, &n_bytes) != 0) {
        return 1;
    }
    copy->changed = archive_entry_mtime(entry);
    return copy_fill(copy, kind, unpacking->bytes, n_bytes) == 0 ? 0 : complain_memory(unpacking);
}

// ---- The archive ----------------------------------------------------------------------------

// Returns 0, or 1 with a message.
static int entry_read(Unpacking *unpacking, struct archive_entry *entry)
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
    const int is_folder = archive_entry_filetype(entry) == AE_IFDIR;
    if (!is_folder) {
        contents_note(&unpacking->contents, path);
    }
    Path parts = {0};
    if (path_read(path, &parts) != 0) {
        return 0;
    }
    const Manifest *manifest = unpacking->manifest;
    const Place place = {parts.folder, parts.name};
    int rank;
    const int i = place_of(manifest->lab, manifest->files, manifest->n_files, &place, &rank);
    if (i < 0 || (is_folder && strcmp(parts.name, manifest->files[i]) != 0)) {
        return 0;
    }
    return entry_keep(unpacking, entry, &place, rank, &unpacking->files[i]);
}

// Read all entries. Returns as unpack() does.
static int entries_read(Unpacking *unpacking)
{
    struct archive_entry *entry;
    int outcome = layers_count(unpacking);
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
        outcome = entry_read(unpacking, entry);
    }
    const int is_told = outcome == 0 && unpacking->n_files == 0 && unpacking->n_told == 0;
    if (is_told &&
        contents_explain(&unpacking->contents, unpacking->message, UNPACK_MESSAGE_BYTES)) {
        return 1;
    }
    return outcome;
}

// ---- Writing --------------------------------------------------------------------------------

// Returns 0, or 1 with a message where too much is left to be written.
static int kept_count(const Unpacking *unpacking)
{
    size_t n_bytes = 0;
    for (int i = 0; i < unpacking->manifest->n_files; i++) {
        for (int k = 0; k < unpacking->files[i].n_kept; k++) {
            n_bytes += unpacking->files[i].kept[k].n_bytes;
        }
    }
    if (n_bytes <= (size_t)UNPACK_MAX_WRITTEN_MEGABYTES << 20) {
        return 0;
    }
    snprintf(unpacking->message, UNPACK_MESSAGE_BYTES,
             "the archive holds at least %.1f MB of the lab's files in places that are equally "
             "good, expected "
             "at most %d MB: hand in each file once",
             (double)n_bytes / (1 << 20), UNPACK_MAX_WRITTEN_MEGABYTES);
    return 1;
}

// Write what is kept, what is taken before what is only named: it may lie in its way. Returns 0, or
// -1 with errno set.
static int kept_write(const Unpacking *unpacking, int folder)
{
    for (int k = 0; k < COPIES_MAX; k++) {
        for (int i = 0; i < unpacking->manifest->n_files; i++) {
            const Copies *file = &unpacking->files[i];
            if (k < file->n_kept && copy_write(&file->kept[k], folder) != 0) {
                return -1;
            }
        }
    }
    return 0;
}

// Say of which files several entries have one path: for a folder they are one file. Returns how
// long that is.
static size_t repeated_say(const Unpacking *unpacking)
{
    size_t n_bytes = 0;
    for (int i = 0; i < unpacking->manifest->n_files; i++) {
        const Copies *file = &unpacking->files[i];
        for (int k = 0; k < copies_count_best(file); k++) {
            const Copy *copy = &file->kept[k];
            char shown[2][MESSAGE_SHOWN_BYTES];
            if (copy->n_entries > 1 && copy->rank < RANK_TOLD && n_bytes < UNPACK_MESSAGE_BYTES) {
                n_bytes += (size_t)snprintf(
                    unpacking->message + n_bytes, UNPACK_MESSAGE_BYTES - n_bytes,
                    "%s%s: %d times in the archive as \"%s%s%s\", %s: the last one counts",
                    n_bytes > 0 ? "\n" : "", file->name, copy->n_entries,
                    message_show(copy->place.folder, shown[0], sizeof shown[0]),
                    copy->place.folder[0] != '\0' ? "/" : "",
                    message_show(copy->place.name, shown[1], sizeof shown[1]),
                    copy->has_changed ? "with different contents" : "always the same");
            }
        }
    }
    return n_bytes;
}

static int is_one_missing(const Unpacking *unpacking)
{
    for (int i = 0; i < unpacking->manifest->n_files; i++) {
        const Copies *file = &unpacking->files[i];
        if (file->n_kept == 0 || file->kept[0].rank >= RANK_TOLD) {
            return 1;
        }
    }
    return 0;
}

// Say what staging cannot see.
static void entries_say(const Unpacking *unpacking)
{
    char list[UNPACK_MESSAGE_BYTES / 2];
    const size_t n_bytes = repeated_say(unpacking);
    if (is_one_missing(unpacking) && n_bytes < UNPACK_MESSAGE_BYTES) {
        contents_list(&unpacking->contents, list, sizeof list);
        snprintf(unpacking->message + n_bytes, UNPACK_MESSAGE_BYTES - n_bytes, "%s%s",
                 n_bytes > 0 ? "\n" : "", list);
    }
}

static void unpacking_free(Unpacking *unpacking)
{
    for (int i = 0; i < unpacking->manifest->n_files; i++) {
        copies_free(&unpacking->files[i]);
    }
    free(unpacking->bytes);
}

int unpack(struct archive *archive, const Manifest *manifest, int folder, char *message)
{
    Unpacking unpacking = {.archive = archive,
                           .manifest = manifest,
                           .message = message,
                           .bytes = malloc(STAGE_MAX_FILE_BYTES + 1)};
    for (int i = 0; i < manifest->n_files; i++) {
        unpacking.files[i].name = manifest->files[i];
    }
    message[0] = '\0';
    int outcome = unpacking.bytes != NULL ? entries_read(&unpacking) : complain_memory(&unpacking);
    if (outcome == 0) {
        outcome = kept_count(&unpacking);
    }
    if (outcome == 0) {
        entries_say(&unpacking);
        outcome = kept_write(&unpacking, folder);
    }
    const int fault = errno;
    unpacking_free(&unpacking);
    errno = fault;
    return outcome;
}
