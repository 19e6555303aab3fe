// Giving reports back: packed as a course system takes them, or as folders with a list for mail.
//
// Read next: feedback.c; gradebook_tool.c, whose command `feedback` calls it.
#ifndef CLASS_FEEDBACK_H
#define CLASS_FEEDBACK_H

#include "gradebook.h"
#include "worksheet.h"

#include <limits.h>

typedef enum FeedbackKind {
    FEEDBACK_MOODLE,   // feedback-moodle.zip, for "Upload multiple feedback files in a zip"
    FEEDBACK_CANVAS,   // feedback-canvas.zip, for "Upload submissions"
    FEEDBACK_ILIAS,    // feedback-ilias.zip, for "Upload multi-feedback file"
    FEEDBACK_FOLDERS,  // feedback/, a folder a student, and feedback.csv
    FEEDBACK_MAIL,     // the same, for students with an address
    N_FEEDBACK_KINDS
} FeedbackKind;

// "moodle", "canvas", "ilias", "folders", "mail". Returns 0, or -1: no such kind.
int feedback_kind_find(const char *name, FeedbackKind *kind);

// A row's report, as the grader wrote it and with what has changed its points: the bytes and how
// many, owned by the caller. NULL after one message.
char *feedback_report(const Gradebook *gradebook, const Row *row, size_t *n_bytes);
void feedback_report_path(const Gradebook *gradebook, const Row *row, char path[PATH_MAX]);

// Write it into the class's folder, and say on stdout what was written, and who has got none.
//   worksheet   the list of participants, by which teams and addresses are known; or NULL
// Returns 0, or -1 after one message.
int feedback_write(const Gradebook *gradebook, const Worksheet *worksheet, FeedbackKind kind);

#endif
