// A small lab and a result of it, for the tests of what is written of a result.
#ifndef UNIT_SAMPLE_RESULT_H
#define UNIT_SAMPLE_RESULT_H

#include "manifest.h"
#include "result.h"

#include <string.h>

static const Manifest manifest = {
    .lab = "01-naive-2d",
    .title = "Naive 2D rendering",
    .files = {(char *)"overlaps_N_Nearer.cl", (char *)"implicit2DRenderer.cl"},
    .n_files = 2,
    .n_tasks = 2,
    .tasks = {{.id = "overlaps_N_Nearer",
               .file = "overlaps_N_Nearer.cl",
               .title = "Does a circle cover the pixel?",
               .hint = "Compare the squares."},
              {.id = "implicit2DRenderer",
               .file = "implicit2DRenderer.cl",
               .title = "The nearest of all",
               .hint = "Remember the depth."}},
    .leaderboard = (char *)"times as fast as lab 00's <kernel>",
};

// A result with a failed, a passed and a not-run check; the failed one says `message`.
static inline Result result_make(const char *message)
{
    Result result = {.lab = "01-naive-2d",
                     .title = "Naive 2D rendering",
                     .submission = "labs/01-naive-2d",
                     .seed = UINT64_MAX,
                     .device = "cpu-x",
                     .sandbox = "bubblewrap",
                     .score = 25,
                     .max_score = 100,
                     .seconds = 4.25,
                     .n_stages = 1,
                     .n_checks = 3};
    result.stages[0] = (StageResult){"Compiling", CHECK_PASSED, NULL};
    result.checks[0] = (CheckResult){.id = "overlaps-inside",
                                     .title = "Clearly inside and outside",
                                     .task = "overlaps_N_Nearer",
                                     .max_points = 25};
    check_pass(&result.checks[0]);
    result.checks[1] = (CheckResult){.id = "overlaps-boundary",
                                     .title = "The boundary belongs to it",
                                     .task = "overlaps_N_Nearer",
                                     .max_points = 15};
    check_fail(&result.checks[1], diagnosis_new("%s", message));
    result.checks[2] = (CheckResult){.id = "picture",
                                     .title = "A random scene",
                                     .task = "implicit2DRenderer",
                                     .max_points = 60,
                                     .status = CHECK_NOT_RUN};
    return result;
}

// The same with every point earned, and the figure of a race; 0: none.
static inline Result full_result_make(double leaderboard)
{
    Result result = result_make("");
    for (int i = 0; i < result.n_checks; i++) {
        check_pass(&result.checks[i]);
    }
    result.score = result.max_score;
    result.leaderboard = leaderboard;
    return result;
}

// Let a failed check of it say what it looks like.
static inline void name_cause(CheckResult *check, const char *looks)
{
    Diagnosis diagnosis = diagnosis_new("%s", check->diagnosis.found);
    diagnosis.cause = strdup(looks);
    check_tell(check, diagnosis);
    check->is_explained = 1;
}

#endif
