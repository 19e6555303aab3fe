// Unpacking what a student handed in: the lab's files out of a zip or tar archive, and no others;
// and what a course system exports of a class: all of it.
//
// An archive is untrusted, and reading one takes a large library: this runs in the sandbox only, as
// the program unpack (unpack_tool.c). It believes no number and no name in it. libarchive's own
// bsdtar would not do: it has no limit for entries or sizes, makes links that lead anywhere, and
// what it says of a file that is no archive ("Missing type keyword in mtree specification") helps
// no student. Read next: places.h, which chooses among what was unpacked.
#ifndef GRADER_UNPACK_H
#define GRADER_UNPACK_H

#include "manifest.h"

struct archive;  // libarchive's

// What an archive may hold; more ends in a message.
enum {
    UNPACK_MAX_ENTRIES = 200000,
    UNPACK_MAX_FILES = 1000,           // entries with one of the wanted names
    UNPACK_MAX_MEGABYTES = 512,        // all entries unpacked
    UNPACK_MAX_LAYERS = 2,             // of compression; a server may add one
    UNPACK_MAX_WRITTEN_MEGABYTES = 4,  // what is written: the largest files of a lab, twice
};

// The longest message, its NUL included.
enum { UNPACK_MESSAGE_BYTES = 2048 };

// A reader for the kinds of archives that are taken, recognised by their content: zip; tar, also
// compressed by gzip, bzip2 or xz. NULL when memory runs out; release with archive_read_free().
struct archive *unpack_reader_new(void);

// Write those entries into an open folder, below the folders that they have in the archive, that
// staging has to see: of each of the manifest's files the copies in its best places and one that is
// less good (copies.h). Of several entries with one path the last one counts, as when tar appends a
// newer file. Absolute paths lose their first slash; those with "..", with a name that is too long,
// or with more than PLACES_MAX_DEPTH folders are passed over. A file of more than
// STAGE_MAX_FILE_BYTES is cut one byte behind that. Nothing is written until all is read.
//   archive    opened
//   manifest   its lab and files
//   folder     an empty folder, open
//   message    out: what is wrong, on 1; on 0 which entries count where several have one path, a
//              line each, or "". For the student, [UNPACK_MESSAGE_BYTES]; it may quote the archive,
//              so it is to be cleaned for display
// Returns 0; 1 when the archive is at fault, and be it that memory runs out while it is read;
// UNPACK_NO_ARCHIVE, without a message, when the file is none that is read here; -1 with errno set
// when the folder is at fault (a full disk).
enum { UNPACK_NO_ARCHIVE = 2 };
int unpack(struct archive *archive, const Manifest *manifest, int folder, char *message);

// Write all entries of a class's export into an open folder, as they are. A link becomes one that
// leads nowhere. What cannot be written as it is (a path that leads elsewhere, two files of one
// path, a name that is no text) is a fault of the archive: nobody's work may be left out.
//   archive    opened, of a reader for exports: it reads several tars behind each other as one
//   folder     an empty folder, open
//   message    out: what is wrong, on 1, or ""; [UNPACK_MESSAGE_BYTES]; to be cleaned for display
// Returns as unpack() does.
struct archive *unpack_export_reader_new(void);
int unpack_export(struct archive *archive, int folder, char *message);

#endif
