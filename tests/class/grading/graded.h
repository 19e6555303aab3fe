// Reading results.json back, for reports over a whole class.
#ifndef GRADER_GRADED_H
#define GRADER_GRADED_H

#include "manifest.h"
#include "result.h"

// A task or a check.
typedef struct Column {
    const char *id, *title;
    int points, max_points;
    // Of a check:
    const char *task;
    const char *message;  // what it found, also where students do not see it
    const char *silent;   // why nothing is said about the answer (silence_name()), or NULL
    const char *cause;    // the known mistake, a fixed sentence; NULL: none is named
    CheckStatus status;
    int is_hidden;  // what it found is not for students
} Column;

// One submission's results. The strings live as long as it does.
typedef struct Graded {
    struct json_t *json;  // owns the strings; NULL: not graded
    const char *lab, *title;
    const char *seed;  // decimal digits
    int has_nothing;   // nothing of the lab was handed in: the stage's message says what was
    int score, max_score;
    Column tasks[MANIFEST_MAX_TASKS];
    int n_tasks;
    Column checks[RESULT_MAX_CHECKS];
    int n_checks;
    const char *failed_stage;       // title of the first stage that failed, or NULL
    const char *stage_message;      // and what it said
    const char *leaderboard_title;  // what its figure counts, or NULL
    double leaderboard;             // within race.h's limits; 0: none
} Graded;

// Read and check a results.json, which may have passed through other hands: fields, types and
// limits as in tests/results.schema.json, and sums that agree. Returns 0, or -1 after one message
// on stderr.
int graded_load(const char *path, Graded *graded);
void graded_free(Graded *graded);

#endif
