// Writing one Result many ways. Each file appears whole or not at all; each function returns 0, or
// -1 after one message on stderr.
#ifndef GRADER_REPORT_H
#define GRADER_REPORT_H

#include "manifest.h"
#include "result.h"

#include <stdio.h>

// What reports for people say behind the figure of a race and what it counts.
#define REPORT_RACE_NOTE " on this device, in this run; gives and costs no points"

// What the report for the terminal tells of the tasks: everything, or one task and of the others a
// line each.
typedef struct ReportTold {
    int is_all;
    const char *task;  // this one; NULL: the first that failed, in the order of work
} ReportTold;

// For the terminal: a line a check, grouped by task, messages and hints under the failed ones, the
// score last. Colours only when `colours` is set.
void report_text(FILE *out, const Manifest *manifest, const Result *result, ReportTold told,
                 int colours);

// What comes below it once the rest is done: how a race ended, and where the report is. Returns -1
// after one message, too, where any of the text could not be written.
int report_text_end(FILE *out, const Manifest *manifest, const Result *result, const char *path);

// results.json; the schema is tests/results.schema.json.
int report_json(const char *path, const Manifest *manifest, const Result *result);

// pictures.json: of each scene where the student's picture is wrong, the picture, the reference and
// the difference, as a list of {"label": ..., "url": "data:..."}. No file, and no older one, where
// there is none.
int report_pictures_json(const char *path, const Result *result);

// One self-contained page: score, checks by task with messages and hints, and for each picture the
// reference, the student's own and the difference side by side, embedded as PNG.
int report_html(const char *path, const Manifest *manifest, const Result *result);

#endif
