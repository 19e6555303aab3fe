// results.json, which the grader wrote, as the desk reads it.
#ifndef DESK_RESULTS_H
#define DESK_RESULTS_H

#include <jansson.h>

// Read a file of the grader's. Returns the object, json_decref() it; or NULL after one message.
json_t *results_load(const char *path);

// A field of an object: a text, "" where there is none; a number, 0 where there is none.
const char *text_of(const json_t *object, const char *field);
int number_of(const json_t *object, const char *field);

// The first check in the order of work that has not passed, or NULL: there is none.
const json_t *results_first_fault(const json_t *results);

// The first check of a task that failed although the task is answered, or NULL.
const json_t *results_task_fault(const json_t *results, const char *task);

// The check that hints are about: of the task of the first fault the first failed check that has
// named the mistake; or the first fault.
const json_t *results_hinted_fault(const json_t *results);

// Is it a check of a task that stands as it was handed out?
int fault_is_unanswered(const json_t *check);

// What is wrong there: the mistake where it is named, else how the program ended where that is why
// there is no answer, else what was found. May be of several lines.
const char *fault_sentence(const json_t *results, const json_t *check);

// Did the submission compile?
int results_are_of_compiled(const json_t *results);

// Was it seen in the pixels of a picture?
int fault_is_in_picture(const json_t *check);

// Call `tell` for each check whose points differ between two results of one lab.
// Returns how many these are.
//   before   NULL: each that has points now
int results_compare(const json_t *before, const json_t *now,
                    void (*tell)(void *context, const json_t *check, int difference),
                    void *context);

#endif
