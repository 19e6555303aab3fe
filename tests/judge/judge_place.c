// Where a run was when it ended, in words: see ProbeStep and JobPlace in judge.h.
//
// The note that says so stands where the student's code can write, too: of it only the name of a
// step of this lab becomes words, and numbers that the job has.
#include "judge.h"

#include <inttypes.h>
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

// "input 17 of 400: box x [0, 4] y [0, 2]"
static void describe_input(const ProbeStep *step, const Sections *written, uint32_t number,
                           JobPlace *place)
{
    size_t n_bytes;
    const unsigned char *inputs = sections_find_any(written, step->name, &n_bytes);
    const size_t n = inputs != NULL ? n_bytes / step->input_bytes : 0;
    if (step->describe != NULL && number < n) {
        char input[sizeof place->with - 40];
        step->describe(inputs + number * step->input_bytes, input, sizeof input);
        snprintf(place->with, sizeof place->with, "input %" PRIu32 " of %zu: %s", number + 1, n,
                 input);
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
        describe_input(place.step, written, number, &place);
    } else if (place.step->describe != NULL) {
        place.step->describe(&number, place.with, sizeof place.with);
    } else {
        describe_scene(written, number, &place);
    }
    return place;
}
