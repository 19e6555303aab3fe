// Entry by entry (see unpack_read.h).
//
// libarchive reads the formats; here is decided how much of that is read. Whatever else an archive
// uses up is its own fault, too: memory here, time and the rest where the program is started
// (unpack_run.c). Read next: unpack.c, unpack_export.c.
#include "unpack_read.h"

#include "unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// ---- Faults of the archive ------------------------------------------------------------------

int unpack_complain(const UnpackReading *reading, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reading->message, UNPACK_MESSAGE_BYTES, format, arguments);
    va_end(arguments);
    return 1;
}

int unpack_complain_encrypted(const UnpackReading *reading)
{
    return unpack_complain(reading, "the archive is encrypted: %s", reading->rules->if_encrypted);
}

int unpack_complain_memory(const UnpackReading *reading)
{
    return unpack_complain(reading, "reading the archive takes too much memory: %s",
                           reading->rules->if_damaged);
}

int unpack_complain_damaged(const UnpackReading *reading)
{
    if (archive_errno(reading->archive) == ENOMEM) {
        return unpack_complain_memory(reading);
    }
    const char *reason = archive_error_string(reading->archive);
    return unpack_complain(reading, "the archive is damaged or cut off (%.120s): %s",
                           reason != NULL ? reason : "for no known reason",
                           reading->rules->if_damaged);
}

// ---- Entries --------------------------------------------------------------------------------

// Each layer may ask for its own tens of megabytes. Returns 0, or 1 where there are too many.
static int layers_count(const UnpackReading *reading)
{
    const int n_layers = archive_filter_count(reading->archive) - 1;  // the file itself is one
    return n_layers <= UNPACK_MAX_LAYERS
               ? 0
               : unpack_complain(reading,
                                 "the archive is compressed %d times over, expected at most %d: %s",
                                 n_layers, UNPACK_MAX_LAYERS, reading->rules->if_damaged);
}

// Count an entry. Returns 0, or 1 when they are too many or too large.
static int entry_count(UnpackReading *reading, struct archive_entry *entry)
{
    const UnpackRules *rules = reading->rules;
    const int64_t most = (int64_t)rules->most_megabytes << 20;
    const int64_t n_bytes = archive_entry_size(entry);
    if (++reading->n_entries > rules->most_entries) {
        return unpack_complain(reading, "the archive holds more than %d files: %s",
                               rules->most_entries, rules->if_large);
    }
    if (n_bytes < 0 || n_bytes > most - reading->n_bytes) {
        return unpack_complain(reading, "the archive holds more than %d MB, unpacked: %s",
                               rules->most_megabytes, rules->if_large);
    }
    reading->n_bytes += n_bytes;
    return 0;
}

int unpack_next(UnpackReading *reading, struct archive_entry **entry)
{
    struct archive *archive = reading->archive;
    if (reading->n_entries == 0 && layers_count(reading) != 0) {
        return 1;
    }
    const int status = archive_read_next_header(archive, entry);
    if (status == ARCHIVE_EOF) {
        *entry = NULL;
        return 0;
    }
    if (status != ARCHIVE_OK && archive_format(archive) == 0) {
        return UNPACK_NO_ARCHIVE;
    }
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN) {
        return archive_read_has_encrypted_entries(archive) > 0 ? unpack_complain_encrypted(reading)
                                                               : unpack_complain_damaged(reading);
    }
    return entry_count(reading, *entry);
}

// ---- Paths ----------------------------------------------------------------------------------

const char *unpack_path_text(struct archive_entry *entry)
{
    // NULL: a name that is no text in this locale; then libarchive may still know it as UTF-8.
    const char *path = archive_entry_pathname(entry);
    return path != NULL ? path : archive_entry_pathname_utf8(entry);
}

int unpack_path_read(const char *text, int most_folders, UnpackPath *path)
{
    int n_folders = 0;
    size_t n_folder = 0;
    path->folder[0] = path->name[0] = '\0';
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
            if (n_folders++ == most_folders) {
                return -1;
            }
            n_folder += (size_t)snprintf(path->folder + n_folder, sizeof path->folder - n_folder,
                                         "%s%s", n_folders > 1 ? "/" : "", path->name);
            if (n_folder >= sizeof path->folder) {
                return -1;
            }
        }
        memcpy(path->name, part, length);
        path->name[length] = '\0';
    }
    return path->name[0] != '\0' ? 0 : -1;
}
