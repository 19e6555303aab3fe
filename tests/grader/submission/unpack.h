// Unpacking what a student handed in: the lab's files out of a zip or tar archive, and no others.
//
// An archive is untrusted, and reading one takes a large library: this runs in the sandbox only, as
// the program unpack (unpack_tool.c). It believes no number and no name in it. libarchive's own
// bsdtar would not do: it has no limit for entries or sizes, makes links that lead anywhere, and
// what it says of a file that is no archive ("Missing type keyword in mtree specification") helps
// no student. Read next: places.h, which chooses among what was unpacked.
#ifndef GRADER_UNPACK_H
#define GRADER_UNPACK_H

#include <stddef.h>

struct archive;  // libarchive's

// What an archive may hold; more ends in a message.
enum {
    UNPACK_MAX_ENTRIES = 200000,
    UNPACK_MAX_FILES = 1000,     // entries with one of the wanted names
    UNPACK_MAX_MEGABYTES = 512,  // all entries unpacked
};

// The longest message, its NUL included.
enum { UNPACK_MESSAGE_BYTES = 256 };

// A reader for the kinds of archives that are taken, recognised by their content: zip; tar, also
// compressed by gzip, bzip2 or xz. NULL when memory runs out; release with archive_read_free().
struct archive *unpack_reader_new(void);

// Write every entry called one of the names into an open folder, below the folders that it has in
// the archive. Absolute paths lose their first slash; those with "..", names that are too long, or
// more than PLACES_MAX_DEPTH folders are passed over. A file of more than STAGE_MAX_FILE_BYTES is
// cut one byte behind that. In place of a link comes a link to nowhere, in place of anything else
// that is no file a folder, so that staging says what was there.
//   archive          opened
//   folder           an empty folder, open
//   names[n_names]   the wanted files' names
//   message          out, on 1: what is wrong, for the student, [UNPACK_MESSAGE_BYTES]; it may
//                    quote the archive, so it is to be cleaned for display
// Returns 0; 1 when the archive is at fault; UNPACK_NO_ARCHIVE, without a message, when the file is
// none that is read here; -1 with errno set when the folder is at fault (a full disk).
enum { UNPACK_NO_ARCHIVE = 2 };
int unpack(struct archive *archive, int folder, char *const *names, int n_names, char *message);

#endif
