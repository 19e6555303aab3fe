// The one result of a grading, which every report is written from.
#ifndef GRADER_RESULT_H
#define GRADER_RESULT_H

#include "diagnosis.h"
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
    const char *task;   // the task's id, one of the manifest's
    int points;         // earned: 0 or max_points
    int max_points;
    CheckStatus status;
    // Of what check_tell() was given. Both owned.
    Diagnosis diagnosis;
    char *message;      // the same as a sentence: what is wrong, where, and what it looks like; may
                        // come from student code's values, never trusted as markup. "" when passed
    int is_explained;   // the message says why: a hint would only lead elsewhere
    int is_own;         // it is the fault of its own answer, whatever else is wrong
    int passes_alone;   // its answer passes it alone, though not in the whole;
    int is_told_alone;  // or fails it there, too, and what was found there is what is said
    const char *alone;  // what else came of testing it alone, in words; NULL: nothing
    int is_hidden;      // what it finds is not for students
} CheckResult;

// Pictures of one scene for the report.
typedef struct PictureResult {
    char title[128];  // "random scene, 317x211: your picture differs in 12 pixels"
    Image reference;  // owned; width 0 when there is none
    Image own;        // owned; width 0 when there is none
    // Owned <svg> elements with their xmlns, made by the grader, or NULL (lab 02's trees).
    char *svg_reference, *svg_own;
} PictureResult;

// A note about the whole submission: staged, compiled, ran.
typedef struct StageResult {
    const char
        *title;  // "Staging", "What stands out", "Sandbox", "Compiling", "Running", "Markers",
                 // "Trying answers alone", "Points", "What to try next"
    CheckStatus status;
    // Compiler output with the student's own file and line, crash, time-out... Owned.
    char *message;
} StageResult;

enum { RESULT_MAX_CHECKS = 32, RESULT_MAX_PICTURES = 12, RESULT_MAX_STAGES = 9 };

typedef struct Result {
    const char *lab;         // "01-naive-2d"
    const char *title;       // of the lab
    const char *submission;  // whose it is, or its path as given
    uint64_t seed;
    char device[256];
    const char *sandbox;   // it ran in: a name of sandbox.h's
    int has_nothing;       // nothing of the lab was handed in: then the score is no verdict
    int score, max_score;  // sums over the checks
    StageResult stages[RESULT_MAX_STAGES];
    int n_stages;
    CheckResult checks[RESULT_MAX_CHECKS];
    int n_checks;
    PictureResult pictures[RESULT_MAX_PICTURES];
    int n_pictures;
    double leaderboard;  // how many of what the manifest's leaderboard counts; 0: none (run/race.h)
    double seconds;      // the whole grading
} Result;

void result_free(Result *result);

// Add a stage. The title is kept, the message copied.
void result_add_stage(Result *result, const char *title, CheckStatus status, const char *message);

// Say this of a check, in the place of what was said before. Takes the diagnosis over.
void check_tell(CheckResult *check, Diagnosis diagnosis);

// Is there no answer to it that could be tried?
int check_is_unanswered(const CheckResult *check);

// Was what it found seen in the pixels of a picture?
int check_is_of_pixels(const CheckResult *check);

// Let it pass with all its points, and nothing to say; or fail with none.
void check_pass(CheckResult *check);
void check_fail(CheckResult *check, Diagnosis diagnosis);

// Release what is said of it.
void check_free(CheckResult *check);

// The word for a status in results.json and in reports: "passed", "failed" or "not-run".
const char *check_status_name(CheckStatus status);

// What reports for people show: nothing is wrong yet with a task that stands as it was handed out,
// though to other systems its checks have failed.
CheckStatus check_status_shown(const CheckResult *check);

// May students see what it found? All that is written for them asks this: a hidden check shows only
// whether it passed, or that its task is not answered yet.
int check_shows(const CheckResult *check);

// Its message, or that what it found is not shown.
const char *check_message_shown(const CheckResult *check);

// Leave out the pictures where a check does not show what it found: they may.
void result_hide_pictures(Result *result);

// Leave out the checks that an instructor has turned off: those that can earn no points.
void result_drop_off(Result *result);

typedef struct TaskPoints {
    int points, max_points;  // sums over the task's checks
    int n_failed, n_not_run;
} TaskPoints;

// What a task earned.
TaskPoints result_task_points(const Result *result, const char *task);

#endif
