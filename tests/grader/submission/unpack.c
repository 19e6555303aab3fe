// The lab's files out of an archive (see unpack.h).
//
// Here is decided which entries are kept. Read next: unpack_read.c, copies.h.
#include "unpack.h"

#include "contents.h"
#include "copies.h"
#include "message.h"
#include "stage.h"
#include "unpack_read.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Unpacking {
    UnpackReading reading;
    const Manifest *manifest;
    int n_files, n_told;  // entries of wanted files, and those whose name or folder is only told
    Contents contents;
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

// ---- Entries --------------------------------------------------------------------------------

// Read an entry's content. Returns 0, or 1 with a message.
static int content_read(Unpacking *unpacking, struct archive_entry *entry, size_t *n_bytes)
{
    if (archive_entry_is_encrypted(entry)) {
        return unpack_complain_encrypted(&unpacking->reading);
    }
    *n_bytes = 0;
    while (*n_bytes <= STAGE_MAX_FILE_BYTES) {
        const la_ssize_t n =
            archive_read_data(unpacking->reading.archive, unpacking->bytes + *n_bytes,
                              STAGE_MAX_FILE_BYTES + 1 - *n_bytes);
        if (n < 0) {  // ARCHIVE_RETRY, too: it may be said without end
            return unpack_complain_damaged(&unpacking->reading);
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
        return unpack_complain(
            &unpacking->reading,
            "the archive holds %s and the like more than %d times: hand in each file once",
            file->name, UNPACK_MAX_FILES);
    }
    if (copies_find(file, place, rank, &copy) != 0) {
        return unpack_complain_memory(&unpacking->reading);
    }
    if (copy == NULL) {
        return 0;
    }
    if (kind == COPY_OF_FILE && !is_told_only && content_read(unpacking, entry, &n_bytes) != 0) {
        return 1;
    }
    copy->changed = archive_entry_mtime(entry);
    return copy_fill(copy, kind, unpacking->bytes, n_bytes) == 0
               ? 0
               : unpack_complain_memory(&unpacking->reading);
}

// ---- The archive ----------------------------------------------------------------------------

// Returns 0, or 1 with a message.
static int entry_read(Unpacking *unpacking, struct archive_entry *entry)
{
    const char *path = unpack_path_text(entry);
    if (path == NULL) {
        return 0;
    }
    const int is_folder = archive_entry_filetype(entry) == AE_IFDIR;
    if (!is_folder) {
        contents_note(&unpacking->contents, path);
    }
    UnpackPath parts;
    if (unpack_path_read(path, PLACES_MAX_DEPTH, &parts) != 0) {
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
    int outcome = unpack_next(&unpacking->reading, &entry);
    while (outcome == 0 && entry != NULL) {
        outcome = entry_read(unpacking, entry);
        if (outcome == 0) {
            outcome = unpack_next(&unpacking->reading, &entry);
        }
    }
    const int is_told = outcome == 0 && unpacking->n_files == 0 && unpacking->n_told == 0;
    if (is_told &&
        contents_explain(&unpacking->contents, unpacking->reading.message, UNPACK_MESSAGE_BYTES)) {
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
    return unpack_complain(&unpacking->reading,
                           "the archive holds at least %.1f MB of the lab's files in places that "
                           "are equally good, expected at most %d MB: hand in each file once",
                           (double)n_bytes / (1 << 20), UNPACK_MAX_WRITTEN_MEGABYTES);
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
                    unpacking->reading.message + n_bytes, UNPACK_MESSAGE_BYTES - n_bytes,
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
        snprintf(unpacking->reading.message + n_bytes, UNPACK_MESSAGE_BYTES - n_bytes, "%s%s",
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
    Unpacking unpacking = {.reading = {archive, &unpack_rules_student, message, 0, 0},
                           .manifest = manifest,
                           .bytes = malloc(STAGE_MAX_FILE_BYTES + 1)};
    for (int i = 0; i < manifest->n_files; i++) {
        unpacking.files[i].name = manifest->files[i];
    }
    message[0] = '\0';
    int outcome = unpacking.bytes != NULL ? entries_read(&unpacking)
                                          : unpack_complain_memory(&unpacking.reading);
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
