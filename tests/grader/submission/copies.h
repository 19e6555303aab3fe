// The copies of one wanted file that an archive holds: what is kept of them while it is read.
//
// Nothing is written until the archive is at its end, as only then it is known which copies count:
// all from the best places (stage_file.c compares them), and of the less good ones the best, for it
// to name. So what an archive may fill is as small as what it may hand in. Used by unpack.c alone;
// read next: places.h, whose ranks decide here, too.
#ifndef GRADER_COPIES_H
#define GRADER_COPIES_H

#include "places.h"

#include <stddef.h>
#include <time.h>

typedef enum CopyKind { COPY_OF_FILE, COPY_OF_LINK, COPY_OF_OTHER } CopyKind;

typedef struct Copy {
    Place place;  // owned
    int rank;
    CopyKind kind;
    unsigned char *bytes;  // of a file; owned
    size_t n_bytes;
    time_t changed;   // when, by the archive
    int n_entries;    // with this path; the last one counts
    int has_changed;  // they are not all the same
} Copy;

enum {
    COPIES_MAX_EQUAL =
        PLACES_MAX_EQUAL + 1,  // one more than stage_file.c takes, so that it says so
    COPIES_MAX = COPIES_MAX_EQUAL + 1,
};

typedef struct Copies {
    const char *name;           // the file's
    Copy kept[COPIES_MAX + 1];  // the best first, equally good ones in the order of their places
    int n_kept;
} Copies;

// Find room for a copy in that place: what is kept of an earlier entry with the same path, or a
// new one, without content. *copy is NULL where better ones leave none. Returns 0, or -1 when
// memory runs out.
int copies_find(Copies *copies, const Place *place, int rank, Copy **copy);

// Put content into a copy, in place of what an earlier entry had. Returns 0, or -1 when memory runs
// out.
int copy_fill(Copy *copy, CopyKind kind, const unsigned char *bytes, size_t n_bytes);

// How many are equally good, and the best.
int copies_count_best(const Copies *copies);

void copies_free(Copies *copies);

// Write a copy where its path leads. In place of a link comes a link to nowhere, in place of
// anything else that is no file a folder, so that staging says what was there. What cannot be
// written (a name that this file system does not take, another copy in its way) is passed over.
//   folder   open
// Returns 0, or -1 with errno set when the folder is at fault.
int copy_write(const Copy *copy, int folder);

#endif
