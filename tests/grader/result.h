// The one result of a grading, which every report is written from.
#ifndef GRADER_RESULT_H
#define GRADER_RESULT_H

#include "image.h"

#include <stdint.h>

typedef enum CheckStatus {
    CHECK_PASSED,
    CHECK_FAILED,
    CHECK_NOT_RUN,  // something before it failed (no file, no compile, a crash): earns 0
} CheckStatus;

// One check, judged.
typedef struct CheckResult {
    const char *id;     // "overlaps-boundary"
    const char *title;  // "Points on the boundary belong to the circle"
    const char *task;   // the task's id
    int points;         // earned: 0 or max_points
    int max_points;
    CheckStatus status;
    char *message;  // what is wrong, where, and what it looks like; may come from student code's
                    // values, never trusted as markup. "" when passed. Owned.
} CheckResult;

// Pictures of one scene for the report.
typedef struct PictureResult {
    char title[128];   // "random scene, 317x211: your picture differs in 12 pixels"
    Image reference;   // owned; width 0 when there is none
    Image own;         // owned; width 0 when there is none
    char *svg_reference, *svg_own;  // owned <svg> elements made by the grader, or NULL (lab 02's trees)
} PictureResult;

// A note about the whole submission: staged, compiled, ran.
typedef struct StageResult {
    const char *title;   // "Staging", "Compiling", "Running"
    CheckStatus status;
    char *message;  // compiler output with the student's own file and line, crash, time-out... Owned.
} StageResult;

enum { RESULT_MAX_CHECKS = 32, RESULT_MAX_PICTURES = 12, RESULT_MAX_STAGES = 4 };

typedef struct Result {
    const char *lab;    // "01-naive-2d"
    const char *title;  // of the lab
    char submission[512];
    uint64_t seed;
    char device[256];
    int score, max_score;  // sums over the checks
    StageResult stages[RESULT_MAX_STAGES];
    int n_stages;
    CheckResult checks[RESULT_MAX_CHECKS];
    int n_checks;
    PictureResult pictures[RESULT_MAX_PICTURES];
    int n_pictures;
    double seconds;  // the whole grading
} Result;

void result_free(Result *result);

#endif
