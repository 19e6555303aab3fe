// All that one grading holds, and its two large steps: judging what ran, and writing it down.
#ifndef GRADER_GRADING_H
#define GRADER_GRADING_H

#include "report_systems.h"
#include "session.h"

typedef struct Grading {
    Session session;
    Variant whole;                         // the submission as it is
    Variant kernels;                       // its kernels with host files as they are handed out
    Variant alone[MANIFEST_MAX_TASKS];     // one answer of it (alone.h)
    int is_untouched[MANIFEST_MAX_TASKS];  // its task stands as it was handed out
    int has_line;                          // it is told at which line of a host file it crashed
    Result result;
} Grading;

// Add a stage to the result.
void grading_add_stage(Grading *grading, const char *title, CheckStatus status,
                       const char *message);

// Judge the submission that has run: as a whole, and each answer that failed there alone. Returns
// 0, or -1 after one message when the machinery failed.
int grading_judge(Grading *grading);

// Write results.json, report.html, a picture and the other formats into a folder, which is made,
// and the summary to stdout. Returns 0, or -1 after one message.
int grading_write(const Grading *grading, const char *output, FormatSet formats);

// Make a folder and its parents. Returns 0, or -1 after one message.
int folders_make(const char *path);

#endif
