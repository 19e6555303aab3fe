// Reading results.json (see results.h).
#include "results.h"

#include "complain.h"
#include "diagnosis.h"

#include <string.h>

json_t *results_load(const char *path)
{
    json_error_t error;
    json_t *results = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (json_is_array(json_object_get(results, "checks")) &&
        json_is_array(json_object_get(results, "tasks"))) {
        return results;
    }
    complain("desk: %s: %s", path, results == NULL ? error.text : "no result of the grader");
    json_decref(results);
    return NULL;
}

const char *text_of(const json_t *object, const char *field)
{
    const char *text = json_string_value(json_object_get(object, field));
    return text != NULL ? text : "";
}

int number_of(const json_t *object, const char *field)
{
    return (int)json_integer_value(json_object_get(object, field));
}

const json_t *results_first_fault(const json_t *results)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(results, "checks"), i, check)
    {
        if (strcmp(text_of(check, "status"), "passed") != 0) {
            return check;
        }
    }
    return NULL;
}

const json_t *results_task_fault(const json_t *results, const char *task)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(results, "checks"), i, check)
    {
        if (strcmp(text_of(check, "task"), task) == 0 && !fault_is_unanswered(check) &&
            strcmp(text_of(check, "status"), "failed") == 0) {
            return check;
        }
    }
    return NULL;
}

const json_t *results_hinted_fault(const json_t *results)
{
    const json_t *first = results_first_fault(results);
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(results, "checks"), i, check)
    {
        if (strcmp(text_of(check, "status"), "failed") == 0 && text_of(check, "cause")[0] != '\0' &&
            strcmp(text_of(check, "task"), text_of(first, "task")) == 0) {
            return check;
        }
    }
    return first;
}

int fault_is_unanswered(const json_t *check)
{
    return strcmp(text_of(check, "silent"), silence_name(SILENCE_UNANSWERED)) == 0;
}

// A stage of the grading, or NULL.
static const json_t *stage_of(const json_t *results, const char *title)
{
    size_t i;
    json_t *stage;
    json_array_foreach(json_object_get(results, "stages"), i, stage)
    {
        if (strcmp(text_of(stage, "title"), title) == 0) {
            return stage;
        }
    }
    return NULL;
}

int results_are_of_compiled(const json_t *results)
{
    return strcmp(text_of(stage_of(results, "Compiling"), "status"), "passed") == 0;
}

const char *fault_sentence(const json_t *results, const json_t *check)
{
    const int has_ended = strcmp(text_of(check, "silent"), silence_name(SILENCE_ENDED)) == 0;
    const char *cause = text_of(check, "cause");
    const char *end = has_ended ? text_of(stage_of(results, "Running"), "message") : "";
    return cause[0] != '\0' ? cause : end[0] != '\0' ? end : text_of(check, "message");
}

int fault_is_in_picture(const json_t *check)
{
    return json_is_true(json_object_get(check, "in_picture"));
}

static int points_in(const json_t *results, const char *id)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(results, "checks"), i, check)
    {
        if (strcmp(text_of(check, "id"), id) == 0) {
            return number_of(check, "points");
        }
    }
    return 0;
}

int results_compare(const json_t *before, const json_t *now,
                    void (*tell)(void *context, const json_t *check, int difference), void *context)
{
    int n_different = 0;
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(now, "checks"), i, check)
    {
        const int difference = number_of(check, "points") - points_in(before, text_of(check, "id"));
        if (difference != 0) {
            tell(context, check, difference);
            n_different++;
        }
    }
    return n_different;
}
