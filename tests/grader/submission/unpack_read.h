// Reading an archive's entries one after the other: what unpack.c, for a student's archive, and
// unpack_export.c, for a whole class's, have in common. Used by these alone.
#ifndef GRADER_UNPACK_READ_H
#define GRADER_UNPACK_READ_H

#include "unpack_rules.h"

#include <limits.h>
#include <stdint.h>

struct archive;  // libarchive's
struct archive_entry;

typedef struct UnpackReading {
    struct archive *archive;
    const UnpackRules *rules;
    char *message;  // [UNPACK_MESSAGE_BYTES]
    int n_entries;
    int64_t n_bytes;  // of all entries, unpacked
} UnpackReading;

// Read the next entry's head. Returns 0 with *entry, which is NULL behind the last; 1 with a
// message; or UNPACK_NO_ARCHIVE.
int unpack_next(UnpackReading *reading, struct archive_entry **entry);

// The entry's path as it is written, or NULL for one that is no text.
const char *unpack_path_text(struct archive_entry *entry);

// The same, taken apart.
typedef struct UnpackPath {
    char folder[PATH_MAX];  // "" is the top
    char name[NAME_MAX + 1];
} UnpackPath;

// Take a path apart, without what says nothing in it: "/", "." and what is empty. Returns 0, or -1
// where nothing is left, or where it leads elsewhere, is too long or has too many folders.
int unpack_path_read(const char *text, int most_folders, UnpackPath *path);

// Write the message. All return 1.
__attribute__((format(printf, 2, 3))) int unpack_complain(const UnpackReading *reading,
                                                          const char *format, ...);
int unpack_complain_memory(const UnpackReading *reading);
int unpack_complain_encrypted(const UnpackReading *reading);
int unpack_complain_damaged(const UnpackReading *reading);  // libarchive could not go on

#endif
