// The file format between grader and probe: named blocks of bytes, one after the other.
//
// The grader writes what a probe shall try (job), the probe writes what came out (results), and the
// grader reads that without believing it: names and sizes are checked against what it expects.
//     each section: char name[24], zero-padded; u64 n_bytes; the bytes, zero-padded to a multiple
//     of 16 (n_bytes does not count that), so that all contents are aligned within the file
// Both sides run on one machine, so bytes are in its own order.
#ifndef PROBES_SECTIONS_H
#define PROBES_SECTIONS_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    SECTION_NAME_BYTES = 24,  // the last one is always zero
    SECTION_ALIGNMENT = 16,
};

// Append a section and flush it, so that a later crash does not lose it. Returns 0, or -1 when
// writing failed or the name is empty or longer than 23 bytes.
int section_write(FILE *file, const char *name, const void *bytes, size_t n_bytes);

typedef struct Sections {
    unsigned char *bytes;  // the whole file
    size_t n_bytes;
} Sections;

// Read a whole section file: a regular file (never a link) of at most max_bytes. Returns 0, or -1
// when it is missing, of another kind, too large or cut off in mid-section (what is whole stays
// readable then); no message.
int sections_load(const char *path, size_t max_bytes, Sections *sections);

// The same from a stream with n_bytes of them. Returns 0, or -1 when fewer came or no memory is
// left; what is cut off in mid-section is no fault here.
int sections_read(FILE *file, size_t n_bytes, Sections *sections);

void sections_free(Sections *sections);

// The bytes of the section called `name` if it is there exactly once with exactly n_bytes; else
// NULL. Aligned for any type.
const void *sections_find(const Sections *sections, const char *name, size_t n_bytes);

// The same with any size; *n_bytes receives it.
const void *sections_find_any(const Sections *sections, const char *name, size_t *n_bytes);

// One section after the other: the first where *place is 0, which is moved on. Returns its bytes
// and sets its name, with all its SECTION_NAME_BYTES, and its size; NULL behind the last.
const void *sections_next(const Sections *sections, size_t *place, const char **name,
                          size_t *n_bytes);

#endif
