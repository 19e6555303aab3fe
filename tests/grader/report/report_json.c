// results.json (see report.h; the schema is tests/results.schema.json).
//
// For programs: every form for another system is made of it. Scores are whole numbers. The seed has
// 64 bits and stands as a string of decimal digits, because many readers of JSON keep numbers as
// doubles and would change it. Read next: graded.c.
#include "report.h"

#include "hints.h"
#include "json_text.h"

#include <inttypes.h>

// In each of these, NULL (no memory, a number that is not finite) makes the whole that it becomes a
// part of NULL as well: jansson hands it on.

static json_t *stages_json(const Result *result)
{
    json_t *stages = json_array();
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        json_add(&stages, json_pack("{s:o, s:s, s:o}", "title", json_line(stage->title), "status",
                                    check_status_name(stage->status), "message",
                                    json_message(stage->message)));
    }
    return stages;
}

static json_t *tasks_json(const Manifest *manifest, const Result *result)
{
    json_t *tasks = json_array();
    for (int i = 0; i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        const TaskPoints sum = result_task_points(result, task->id);
        json_add(&tasks, json_pack("{s:s, s:o, s:s, s:i, s:i, s:o}", "id", task->id, "title",
                                   json_line(task->title), "file", task->file, "points", sum.points,
                                   "max_points", sum.max_points, "hint",
                                   json_line(task_hint(manifest, result, task))));
    }
    return tasks;
}

// What students must not see is told to the instructor alone: a handout's grader leaves it out.
static json_t *check_json(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const int is_told = check_shows(check) || manifest_has_solution(manifest->lab);
    const char *cause = is_told ? check->diagnosis.cause : NULL;
    const char *silence = silence_name(check->diagnosis.silence);
    return json_pack("{s:o, s:o, s:o, s:i, s:i, s:s, s:o, s:s*, s:o*, s:o*, s:o, s:o*}", "id",
                     json_line(check->id), "title", json_line(check->title), "task",
                     json_line(check->task), "points", check->points, "max_points",
                     check->max_points, "status", check_status_name(check->status), "message",
                     json_message(check_message_shown(check)), "silent", silence, "in_picture",
                     check_shows(check) && check_is_of_pixels(check) ? json_true() : NULL, "cause",
                     cause != NULL ? json_line(cause) : NULL, "hint",
                     json_line(check_hint(manifest, result, check)), "found",
                     is_told && !check_shows(check) ? json_message(check->message) : NULL);
}

static json_t *checks_json(const Manifest *manifest, const Result *result)
{
    json_t *checks = json_array();
    for (int i = 0; i < result->n_checks; i++) {
        json_add(&checks, check_json(manifest, result, &result->checks[i]));
    }
    return checks;
}

static json_t *result_json(const Manifest *manifest, const Result *result)
{
    char seed[24];
    snprintf(seed, sizeof seed, "%" PRIu64, result->seed);
    return json_pack("{s:o, s:o, s:i, s:i, s:s, s:o, s:s, s:o, s:f, s:o, s:o, s:o}", "lab",
                     json_line(result->lab), "title", json_line(result->title), "score",
                     result->score, "max_score", result->max_score, "seed", seed, "device",
                     json_line(result->device), "sandbox", result->sandbox, "submission",
                     json_line(result->submission), "seconds", result->seconds, "stages",
                     stages_json(result), "tasks", tasks_json(manifest, result), "checks",
                     checks_json(manifest, result));
}

// Two fields come last, and only where there is something to say: a figure, or that nothing of the
// lab was handed in.
static json_t *result_json_with_options(const Manifest *manifest, const Result *result)
{
    json_t *json = result_json(manifest, result);
    if (json != NULL && result->has_nothing) {
        json_object_set_new(json, "nothing_of_lab", json_true());
    }
    if (json == NULL || result->leaderboard == 0) {
        return json;
    }
    json_t *entry = json_pack("{s:o, s:f}", "title", json_line(manifest->leaderboard), "value",
                              result->leaderboard);
    if (json_object_set_new(json, "leaderboard", entry) != 0) {
        json_decref(json);
        return NULL;
    }
    return json;
}

int report_json(const char *path, const Manifest *manifest, const Result *result)
{
    return json_save(path, result_json_with_options(manifest, result), JSON_INDENT(2));
}
