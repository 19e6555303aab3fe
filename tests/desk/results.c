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

static int has_text(const json_t *object, const char *field, const char *text)
{
    return strcmp(text_of(object, field), text) == 0;
}

// The first entry of a list of the results whose field has, or has not, this text; or NULL.
static const json_t *first_of(const json_t *results, const char *list, const char *field, int has,
                              const char *text)
{
    size_t i;
    json_t *entry;
    json_array_foreach(json_object_get(results, list), i, entry)
    {
        if (has_text(entry, field, text) == has) {
            return entry;
        }
    }
    return NULL;
}

const json_t *results_first_fault(const json_t *results)
{
    return first_of(results, "checks", "status", 0, "passed");
}

// The first failed check of a task whose mistake is named, or else that is answered; or NULL.
static const json_t *failed_check(const json_t *results, const char *task, int is_named)
{
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(results, "checks"), i, check)
    {
        if (has_text(check, "task", task) && has_text(check, "status", "failed") &&
            !(is_named ? has_text(check, "cause", "") : fault_is_unanswered(check))) {
            return check;
        }
    }
    return NULL;
}

const json_t *results_task_fault(const json_t *results, const char *task)
{
    return failed_check(results, task, 0);
}

const json_t *results_hinted_fault(const json_t *results)
{
    const json_t *first = results_first_fault(results);
    const json_t *named = failed_check(results, text_of(first, "task"), 1);
    return named != NULL ? named : first;
}

int fault_is_unanswered(const json_t *check)
{
    return has_text(check, "silent", silence_name(SILENCE_UNANSWERED));
}

int results_are_of_compiled(const json_t *results)
{
    return has_text(first_of(results, "stages", "title", 1, "Compiling"), "status", "passed");
}

const char *fault_sentence(const json_t *results, const json_t *check)
{
    const char *cause = text_of(check, "cause");
    const char *end = has_text(check, "silent", silence_name(SILENCE_ENDED))
                          ? text_of(first_of(results, "stages", "title", 1, "Running"), "message")
                          : "";
    return cause[0] != '\0' ? cause : end[0] != '\0' ? end : text_of(check, "message");
}

int fault_is_in_picture(const json_t *check)
{
    return json_is_true(json_object_get(check, "in_picture"));
}

int results_compare(const json_t *before, const json_t *now,
                    void (*tell)(void *context, const json_t *check, int difference), void *context)
{
    int n_different = 0;
    size_t i;
    json_t *check;
    json_array_foreach(json_object_get(now, "checks"), i, check)
    {
        const json_t *old = first_of(before, "checks", "id", 1, text_of(check, "id"));
        const int difference = number_of(check, "points") - number_of(old, "points");
        if (difference != 0) {
            tell(context, check, difference);
            n_different++;
        }
    }
    return n_different;
}
