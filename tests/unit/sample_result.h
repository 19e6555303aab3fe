// A small lab and a result of it, for the tests of what is written of a result.
#ifndef UNIT_SAMPLE_RESULT_H
#define UNIT_SAMPLE_RESULT_H

#include "manifest.h"
#include "message.h"
#include "result.h"

#include <string.h>

static const Manifest manifest = {
    .lab = "01-naive-2d",
    .title = "Naive 2D rendering",
    .n_tasks = 2,
    .tasks = {{.id = "overlaps_N_Nearer",
               .file = "overlaps_N_Nearer.cl",
               .title = "Does a circle cover the pixel?",
               .points = 40,
               .hint = "Compare the squares."},
              {.id = "implicit2DRenderer",
               .file = "implicit2DRenderer.cl",
               .title = "The nearest of all",
               .points = 60,
               .hint = "Remember the depth."}},
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
    result.checks[0] = (CheckResult){"overlaps-inside",
                                     "Clearly inside and outside",
                                     "overlaps_N_Nearer",
                                     25,
                                     25,
                                     CHECK_PASSED,
                                     strdup(""),
                                     0,
                                     0,
                                     0};
    result.checks[1] = (CheckResult){"overlaps-boundary",
                                     "The boundary belongs to it",
                                     "overlaps_N_Nearer",
                                     0,
                                     15,
                                     CHECK_FAILED,
                                     strdup(message),
                                     message_names_cause(message),
                                     0,
                                     0};
    result.checks[2] = (CheckResult){
        "picture", "A random scene", "implicit2DRenderer", 0, 60, CHECK_NOT_RUN, NULL, 0, 0, 0};
    return result;
}

#endif
