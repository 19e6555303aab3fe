// The right answers to a lab's job: the solution's, which make has run natively before
// (UNIT_ANSWERS in tests/tests.mk).
//
// Read next: right_answers_sections.h.
#ifndef UNIT_RIGHT_ANSWERS_H
#define UNIT_RIGHT_ANSWERS_H

#include "judge_07.h"
#include "kept_answers.h"
#include "path.h"
#include "right_answers_sections.h"

// The scenes whose work is judged, in labs that count it in more of them; -1 behind the last.
static const int judged_work[][8] = {
    [3] = {3, 7, 10, 13, -1},  // a wide one, empty leaves, a root that is a leaf, a long list
    [5] = {1, 4, 7, -1},       // SMALL, TIES and "behind"
    [7] = {RANDOM + 2, RANDOM + 6, RANDOM + 7, RANDOM + N_RANDOM - 1, DEEP, FLAKE, -1},
    [9] = {0, 8, 16, 21, -1},  // those of judge_09_sent.c
};

// Is a section judged? Not what it says of the device, the time, and that it came to its end.
static inline int is_judged(size_t lab, const char *name)
{
    static const char *const others[] = {"device", "grader-times", "end"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        if (strcmp(name, others[i]) == 0) {
            return 0;
        }
    }
    if (strncmp(name, "work.", 5) != 0 || lab >= sizeof judged_work / sizeof *judged_work) {
        return 1;
    }
    const int *scenes = judged_work[lab];
    while (*scenes >= 0 && *scenes != atoi(name + 5)) {
        scenes++;
    }
    return *scenes >= 0;
}

// The answers to the job of a seed, of one that make has run: what is judged of them. Free with
// sections_free().
static inline Sections right_answers(const char *lab, uint64_t seed)
{
    const char *build = getenv("BUILD"), *name;
    char folder[PATH_MAX];
    const void *bytes;
    size_t place = 0, n_bytes;
    Sections kept;
    Allowance allowance = {0};
    Writer writer;
    path_make(folder, "%s/native/answers/%s", build != NULL ? build : "build", lab);
    cr_assert_eq(kept_answers_load(folder, seed, &kept, &allowance), 0,
                 "%s: no answers to seed %d: make suites", folder, (int)seed);
    writer_open(&writer);
    while ((bytes = sections_next(&kept, &place, &name, &n_bytes)) != NULL) {
        if (is_judged((size_t)atoi(lab), name)) {
            answer(&writer, name, bytes, n_bytes);
        }
    }
    sections_free(&kept);
    return writer_close(&writer);
}

#endif
