// What a sanitizer wrote down, in a student's words.
//
// A run ends at the first fault. It leaves the sanitizer's report and, by sanitized.c of
// tests/native/, which array and which work-item it was. Both are files that the student's code
// could write, too, as a sanitizer is a part of the program: taken from them are numbers, a name,
// and which of our sentences fits. memcheck_findings.c sees whether there are such lines.
// Read next: memcheck_passes.c, which runs it.
#ifndef GRADER_SANITIZER_LOG_H
#define GRADER_SANITIZER_LOG_H

#include "manifest.h"

typedef struct Finding {
    char says[256];     // "reads circles[4], but `circles` has 4 entries, 0 to 3"
    const char *to_do;  // a sentence, or NULL
    // The first place in a file that a student hands in, which belongs to the manifest; or NULL.
    const char *file;
    int line;  // from 1 on
    // Where it went wrong in a given file that this line calls, from the course's folder; or "".
    char given[128];
    int given_line;
    char work_item[48];  // "(3, 0)", or ""
} Finding;

// Read a report.
//   place   what sanitized.c left; "" for nothing
// Returns 1, or 0 where the report tells of no fault at a line that is known.
int finding_read(const char *report, const char *place, const Manifest *manifest, Finding *finding);

#endif
