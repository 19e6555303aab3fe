// Where a run was when it ended, in words: see JobPart, SceneStep and JobPlace in judge.h.
//
// The note that says so stands where the student's code can write, too: of it only the name of a
// section of this lab becomes words, and numbers that the job has.
#include "judge.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

// The inputs of this name, or NULL.
static const JobPart *part_find(const Judge *judge, const char *name)
{
    for (int i = 0; i < judge->n_parts; i++) {
        if (judge->parts[i].input_bytes > 0 && strcmp(judge->parts[i].section, name) == 0) {
            return &judge->parts[i];
        }
    }
    return NULL;
}

// What is done with scenes whose answers have this name, or NULL.
static const SceneStep *step_find(const Judge *judge, const char *name)
{
    for (int i = 0; i < MOST_SCENE_STEPS && judge->scene_steps[i].answers != NULL; i++) {
        if (strcmp(judge->scene_steps[i].answers, name) == 0) {
            return &judge->scene_steps[i];
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
static void describe_input(const Job *job, const JobPart *part, const Sections *written,
                           uint32_t number, JobPlace *place)
{
    size_t n_bytes;
    const unsigned char *inputs = sections_find_any(written, part->section, &n_bytes);
    const size_t n = inputs != NULL ? n_bytes / part->input_bytes : 0;
    if (number < n) {
        char input[sizeof place->with - 40];
        if (part->describe != NULL) {
            part->describe(inputs + number * part->input_bytes, input, sizeof input);
        } else {
            describe_by_check(job, part->section, number, n, input, sizeof input);
        }
        snprintf(place->with, sizeof place->with, "input %" PRIu32 " of %zu%s%s", number + 1, n,
                 input[0] != '\0' ? ": " : "", input);
        place->suspect =
            part->suspect != NULL ? part->suspect(inputs + number * part->input_bytes) : NULL;
    } else if (part->describe == NULL && n > 0) {
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

// "in pixel_on_display or primary_ray"
static void say_tasks(const char *tasks, JobPlace *place)
{
    const char *second = strchr(tasks, ' ');
    place->task = second == NULL ? tasks : NULL;
    snprintf(place->where, sizeof place->where, "in %.*s%s%s", (int)strcspn(tasks, " "), tasks,
             second != NULL ? " or" : "", second != NULL ? second : "");
}

JobPlace job_place(const Job *job, const Sections *written, const char *name, uint32_t number)
{
    JobPlace place = {.suspect = NULL};
    const JobPart *part = part_find(job->judge, name);
    const SceneStep *step = step_find(job->judge, name);
    if (part != NULL) {
        say_tasks(part->tasks, &place);
        describe_input(job, part, written, number, &place);
    } else if (step != NULL) {
        snprintf(place.where, sizeof place.where, "%s", step->where);
        place.task = step->task;
        describe_scene(written, number, &place);
    }
    return place;
}
