// Where a run was when it ended, in words: see ProbeStep and JobPlace in judge.h.
//
// The note that says so stands where the student's code can write, too: of it only the name of a
// step of this lab becomes words, and numbers that the job has.
#include "judge.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static const ProbeStep *step_find(const Judge *judge, const char *name)
{
    for (int i = 0; i < judge->n_steps; i++) {
        if (strcmp(judge->steps[i].name, name) == 0) {
            return &judge->steps[i];
        }
    }
    return NULL;
}

// The function that a check judges by the answers to a section's n inputs, or NULL.
static const Function *function_find(const Judge *judge, const char *section, size_t n)
{
    for (int i = 0; i < judge->n_checks; i++) {
        const Function *function = judge->checks[i].function;
        if (function != NULL && strcmp(function->section, section) == 0 &&
            (size_t)function->n == n) {
            return function;
        }
    }
    return NULL;
}

// Where a check's words about an input end and those about the answer begin, or NULL.
static const char *answer_begin(const char *told)
{
    const char *found = strstr(told, ": found");
    return found != NULL ? found : strstr(told, ": your code ");
}

// The words for an input on the device: what a check says of a wrong answer to it begins with them,
// and the answer follows. "" where no check has any.
static void describe_by_check(const Job *job, const char *section, uint32_t number, size_t n,
                              char *words, size_t n_room)
{
    const Function *function = function_find(job->judge, section, n);
    void *answers = function != NULL ? calloc(n, function->answer_bytes) : NULL;
    char *told = answers != NULL ? function->describe((const char *)job + function->inputs,
                                                      (int)number, answers)
                                 : NULL;
    const char *answer = told != NULL ? answer_begin(told) : NULL;
    snprintf(words, n_room, "%.*s", answer != NULL ? (int)(answer - told) : 0, answer ? told : "");
    free(told);
    free(answers);
}

// "input 17 of 400: box x [0, 4] y [0, 2]"
static void describe_input(const Job *job, const ProbeStep *step, const Sections *written,
                           uint32_t number, JobPlace *place)
{
    size_t n_bytes;
    const unsigned char *inputs = sections_find_any(written, step->name, &n_bytes);
    const size_t n = inputs != NULL ? n_bytes / step->input_bytes : 0;
    if (number < n) {
        char input[sizeof place->with - 40];
        if (step->describe != NULL) {
            step->describe(inputs + number * step->input_bytes, input, sizeof input);
        } else {
            describe_by_check(job, step->name, number, n, input, sizeof input);
        }
        snprintf(place->with, sizeof place->with, "input %" PRIu32 " of %zu%s%s", number + 1, n,
                 input[0] != '\0' ? ": " : "", input);
        place->suspect =
            step->suspect != NULL ? step->suspect(inputs + number * step->input_bytes) : NULL;
    } else if (step->describe == NULL && n > 0) {
        snprintf(place->with, sizeof place->with, "with one of %zu inputs", n);
    }
}

// The title of the scene.
static void describe_scene(const Sections *written, uint32_t number, JobPlace *place)
{
    char name[SECTION_NAME_BYTES];
    size_t n_bytes;
    const int length = snprintf(name, sizeof name, "scene.%" PRIu32 ".title", number);
    const char *title =
        length < (int)sizeof name ? sections_find_any(written, name, &n_bytes) : NULL;
    if (title != NULL) {
        snprintf(place->with, sizeof place->with, "%.*s", (int)n_bytes, title);
    }
}

JobPlace job_place(const Job *job, const Sections *written, const char *name, uint32_t number)
{
    JobPlace place = {.step = step_find(job->judge, name)};
    if (place.step == NULL) {
        return place;
    }
    if (place.step->input_bytes > 0) {
        describe_input(job, place.step, written, number, &place);
    } else {
        describe_scene(written, number, &place);
    }
    return place;
}
