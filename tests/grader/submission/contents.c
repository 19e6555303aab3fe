// What an archive holds besides (see contents.h).
#include "contents.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

int archive_stem_length(const char *path)
{
    static const char *const endings[] = {
        ".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst", ".zip", ".tar",  ".gz", ".tgz", ".bz2",
        ".tbz",    ".tbz2",    ".xz",     ".txz",     ".zst", ".tzst", ".7z", ".rar"};
    const size_t n_path = strlen(path);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        const size_t n_ending = strlen(endings[i]);
        if (n_path > n_ending && strcasecmp(path + n_path - n_ending, endings[i]) == 0) {
            return (int)(n_path - n_ending);
        }
    }
    return 0;
}

void contents_note(Contents *contents, const char *path)
{
    if (strcmp(path, "[Content_Types].xml") == 0 || strcmp(path, "META-INF/manifest.xml") == 0) {
        contents->is_office = 1;
    }
    if (archive_stem_length(path) > 0) {
        const char *slash = strrchr(path, '/');
        message_show(slash != NULL ? slash + 1 : path, contents->inner, sizeof contents->inner);
    }
    if (contents->n_files < CONTENTS_MAX_SHOWN) {
        message_show(path, contents->shown[contents->n_files], MESSAGE_SHOWN_BYTES);
    }
    contents->n_files++;
}

int contents_explain(const Contents *contents, char *message, size_t n_bytes)
{
    if (contents->n_files == 0) {
        snprintf(message, n_bytes,
                 "the archive is empty: pack the lab's files and hand it in again");
    } else if (contents->is_office) {
        snprintf(message, n_bytes,
                 "found an office program's document: hand in the source files themselves, in a "
                 "folder or a zip or tar archive");
    } else if (contents->inner[0] != '\0') {
        snprintf(message, n_bytes,
                 "the archive holds another one, %s, and none of the lab's files: hand in the "
                 "inner one",
                 contents->inner);
    } else {
        return 0;
    }
    return 1;
}

void contents_list(const Contents *contents, char *message, size_t n_bytes)
{
    size_t length = (size_t)snprintf(message, n_bytes, "the archive holds ");
    for (int i = 0; i < contents->n_files && i < CONTENTS_MAX_SHOWN && length < n_bytes; i++) {
        length += (size_t)snprintf(message + length, n_bytes - length, "%s\"%s\"",
                                   i > 0 ? ", " : "", contents->shown[i]);
    }
    if (contents->n_files > CONTENTS_MAX_SHOWN && length < n_bytes) {
        snprintf(message + length, n_bytes - length, " and %d more",
                 contents->n_files - CONTENTS_MAX_SHOWN);
    }
}
