// All that one grading holds, and its two large steps: judging what ran, and writing it down.
#ifndef GRADER_GRADING_H
#define GRADER_GRADING_H

#include "report.h"
#include "result.h"
#include "session.h"

// What came of trying a task's answer alone.
typedef struct AloneVerdicts {
    int was_tried;
    int passes[RESULT_MAX_CHECKS];  // of its checks; 0 for those of others
    int points;                     // of those that pass
} AloneVerdicts;

typedef struct Grading {
    Session session;
    char *build_log;  // of the files that were handed in, where only the answers in them compile
    Variant whole;    // the submission as it is
    Variant kernels;  // its kernels with host files as they are handed out
    Variant alone[MANIFEST_MAX_TASKS];           // one answer of it (alone.h)
    AloneVerdicts verdicts[MANIFEST_MAX_TASKS];  // of it
    int passes_beside[RESULT_MAX_CHECKS];        // without what stands beside the answers
    int is_saved_beside;                         // by which checks pass that do not in the whole
    int is_replaced[MANIFEST_MAX_FILES];         // this file could not be used
    int is_untouched[MANIFEST_MAX_TASKS];  // its task stands as it was handed out, or was not tried
    int has_no_time;       // answers are left that were not tried alone: all tries took too long
    int has_line;          // the report says at which line of a host file it crashed
    const char *end_task;  // in whose lines it ended, or else in whose function; NULL: not known
    Result result;
} Grading;

// Make the whole of what was handed in, with the file as it is handed out in the place of each that
// cannot be used. Returns 1; 0 where no file can be used, so that there is nothing to judge; -1
// after one message.
int grading_stage(Grading *grading, const char *submission);

// The path of one of the lab's files as it was handed in; of their folder, where `file` is "".
void grading_own_path(const Grading *grading, const char *file, char path[PATH_MAX]);

// Was this file of the lab replaced then?
int grading_is_replaced(const Grading *grading, const char *file);

// Put the lab's checks into the result, each as not run.
void grading_list_checks(Grading *grading);

// Judge the submission that has run: as a whole, and each answer that failed there alone. Returns
// 0, or -1 after one message when the machinery failed.
int grading_judge(Grading *grading);

// Where what was handed in does not compile: run what stands between its markers, in the files as
// they are handed out, in its place; with a macro that one answer defines for another one where it
// compiles only so. Returns 0, or -1 after one message.
int grading_retry(Grading *grading);

// Try each answer that failed alone, and let its task have the points that it earns there where
// another answer is to blame for what it lost in the whole. Returns 0, or -1 after one message.
int grading_try_alone(Grading *grading);

// Is check number i one of task number t's?
int grading_is_of(const Grading *grading, int i, int t);

// Has the whole compiled, and come to its end?
int grading_is_finished(const Grading *grading);

// Say of check number i of task t, which did not pass in the whole, what came of trying its answer
// alone (grading_told.c).
//   is_others   another answer may have a part in what was found in the whole
void grading_tell_alone(Grading *grading, int t, int i, int is_others);

// Let all answers run together once more, without what stands beside them: which checks pass then
// is noted, and told where it is more than in the whole (grading_together.c). Returns 0, or -1
// after one message.
int grading_try_together(Grading *grading);

// The macros of the student's own files that those which are handed out do not define: "r, x"; ""
// for none; of many the first. Owned by the caller.
char *grading_own_macros(const Grading *grading);

// A macro that the answer to task number t uses, and that the student defines outside of it; NULL:
// none. Owned by the caller.
char *grading_lacked_macro(const Grading *grading, int t);

// The student's answer to a task: what stands in its hole, or NULL when the markers are gone. Owned
// by the caller.
char *grading_answer(const Grading *grading, const Task *task);

// Print the verdict, which tells of what `told` says, once the folder for the reports is made.
// Returns 0, or -1 after one message.
int grading_tell(const Grading *grading, const char *output, ReportTold told);

// Write results.json, report.html and pictures into that folder; print how a race ended
// and where the report is. Returns 0, or -1 after one message, also where the verdict could not be
// printed.
int grading_write(const Grading *grading, const char *output);

#endif
