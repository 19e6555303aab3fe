// Reports as texts, and what must stand in them, for the tests of each report.
#ifndef UNIT_REPORT_TEXTS_H
#define UNIT_REPORT_TEXTS_H

#include "report.h"
#include "sample_result.h"

#include <criterion/criterion.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// The whole of a stream or file, with its length; free() it.
static inline char *stream_text(FILE *file)
{
    fseek(file, 0, SEEK_END);
    long length = ftell(file);
    rewind(file);
    char *text = calloc(1, (size_t)length + 1);
    cr_assert_eq(fread(text, 1, (size_t)length, file), (size_t)length);
    fclose(file);
    return text;
}

static inline char *text_report(const Result *result, int colours)
{
    FILE *file = tmpfile();
    report_text(file, &manifest, result, (ReportTold){.is_all = 1}, colours);
    cr_assert_eq(report_text_end(file, &manifest, result, "03/report.html"), 0);
    return stream_text(file);
}

typedef int Report(const char *path, const Manifest *manifest, const Result *result);

// What a report writes to a file.
static inline char *file_report(Report *report, const Result *result)
{
    char folder[] = "/tmp/test-report-XXXXXX";
    cr_assert_not_null(mkdtemp(folder));
    char path[64];
    snprintf(path, sizeof path, "%s/report", folder);
    cr_assert_eq(report(path, &manifest, result), 0);
    char *text = stream_text(fopen(path, "rb"));
    unlink(path);
    cr_expect_eq(rmdir(folder), 0, "something else was left in the folder");
    return text;
}

static inline void expect_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) != NULL, "expected \"%s\" in:\n%s", part, text);
}

static inline void expect_no_part(const char *text, const char *part)
{
    cr_expect(strstr(text, part) == NULL, "expected no \"%s\" in:\n%s", part, text);
}

// A text n times over; free() it.
static inline char *repeated(const char *piece, size_t n)
{
    char *text = calloc(n, strlen(piece) + 1);
    for (size_t i = 0; i < n; i++) {
        memcpy(text + i * strlen(piece), piece, strlen(piece));
    }
    return text;
}

#endif
