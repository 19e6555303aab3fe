// Keeping progress.json (see record.h).
#include "record.h"

#include "complain.h"
#include "json_text.h"
#include "results.h"

#include <string.h>
#include <time.h>
#include <unistd.h>

json_t *record_load(void)
{
    json_error_t error;
    if (access(RECORD_PATH, F_OK) != 0) {
        return json_object();
    }
    json_t *record = json_load_file(RECORD_PATH, JSON_REJECT_DUPLICATES, &error);
    if (!json_is_object(record)) {
        complain("desk: " RECORD_PATH ": cannot be read: %s; delete it, and grade your labs again",
                 record == NULL ? error.text : "no object");
        json_decref(record);
        return NULL;
    }
    return record;
}

int record_save(json_t *record)
{
    return json_save(RECORD_PATH, record, JSON_INDENT(2));
}

// Local time, as on the student's clock.
static json_t *time_now(void)
{
    char text[32];
    const time_t now = time(NULL);
    struct tm local;
    strftime(text, sizeof text, "%Y-%m-%d %H:%M", localtime_r(&now, &local));
    return json_string(text);
}

int record_note(const json_t *results)
{
    json_t *record = record_load();
    if (record == NULL) {
        return -1;
    }
    const char *lab = text_of(results, "lab");
    const json_t *old = json_object_get(record, lab), *fault = results_hinted_fault(results);
    const int score = number_of(results, "score"), best = number_of(old, "best");
    const char *task = text_of(fault, "task"), *check = text_of(fault, "id");
    const int is_same =
        strcmp(text_of(old, "task"), task) == 0 && strcmp(text_of(old, "check"), check) == 0;
    json_t *tasks = json_object();
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(results, "tasks"), i, one)
    {
        json_object_set_new(tasks, text_of(one, "id"), json_integer(number_of(one, "points")));
    }
    json_object_set_new(record, lab,
                        json_pack("{s:o, s:i, s:i, s:i, s:o, s:s, s:s, s:i}", "when", time_now(),
                                  "score", score, "best", score > best ? score : best, "max_score",
                                  number_of(results, "max_score"), "tasks", tasks, "task", task,
                                  "check", check, "hints", is_same ? number_of(old, "hints") : 0));
    return record_save(record);
}
