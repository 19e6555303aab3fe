// The section file of right answers, written in memory.
//
// Read next: right_answers.h.
#ifndef UNIT_RIGHT_ANSWERS_SECTIONS_H
#define UNIT_RIGHT_ANSWERS_SECTIONS_H

#include "jobs.h"
#include "sections.h"
#include "work.h"

#include <criterion/criterion.h>
#include <stdlib.h>
#include <string.h>

typedef struct Writer {
    FILE *file;
    char *bytes;
    size_t n_bytes;
} Writer;

static inline void writer_open(Writer *writer)
{
    *writer = (Writer){0};
    writer->file = open_memstream(&writer->bytes, &writer->n_bytes);
    cr_assert_not_null(writer->file);
}

static inline Sections writer_close(Writer *writer)
{
    fclose(writer->file);
    return (Sections){(unsigned char *)writer->bytes, writer->n_bytes};
}

static inline void answer(Writer *writer, const char *name, const void *bytes, size_t n_bytes)
{
    cr_assert_eq(section_write(writer->file, name, bytes, n_bytes), 0);
}

// Section "name.k" or "name.k.part".
static inline const char *numbered(const char *name, int k, const char *part)
{
    static char text[2 * SECTION_NAME_BYTES];
    snprintf(text, sizeof text, "%s.%d%s%s", name, k, part ? "." : "", part ? part : "");
    return text;
}

#endif
