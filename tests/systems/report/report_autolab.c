// The last lines on stdout that Autolab reads (see report_systems.h).
//
// The last one gives points to the problems of the assessment, which are called like the tasks. The
// one before it is Autolab's formatted feedback: a stage a task, a test a check.
// https://docs.autolabproject.com/features/formatted-feedback/
// Flow: judging -> result -> REPORTS. Read next: report_prairielearn.c.
#include "complain.h"
#include "json_text.h"
#include "output_file.h"
#include "report_systems.h"
#include "report_words.h"

#include <stdlib.h>
#include <string.h>

static json_t *check_json(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    if (check->status == CHECK_PASSED) {
        return json_pack("{s:b}", "passed", 1);
    }
    char *words = check_words(manifest, result, check);
    json_t *json = json_pack("{s:b, s:o}", "passed", 0, "hint", json_message(words));
    free(words);
    return json;
}

static json_t *feedback_json(const Manifest *manifest, const Result *result)
{
    json_t *stages = json_array();
    json_t *feedback = json_pack("{s:s, s:O}", "_presentation", "semantic", "stages", stages);
    int failed = feedback == NULL;
    for (int t = 0; t < manifest->n_tasks && !failed; t++) {
        const char *id = manifest->tasks[t].id;
        json_t *stage = json_object();
        for (int i = 0; i < result->n_checks && !failed; i++) {
            const CheckResult *check = &result->checks[i];
            if (strcmp(check->task, id) == 0) {
                json_t *json = check_json(manifest, result, check);
                failed = json_object_set_new(stage, check->title, json) != 0;
            }
        }
        failed = json_array_append_new(stages, json_string(id)) != 0 || failed;
        failed = json_object_set_new(feedback, id, stage) != 0 || failed;
    }
    json_decref(stages);
    if (failed) {
        json_decref(feedback);
        return NULL;
    }
    return feedback;
}

static json_t *scores_json(const Manifest *manifest, const Result *result)
{
    json_t *scores = json_object();
    for (int t = 0; t < manifest->n_tasks; t++) {
        const TaskPoints sum = result_task_points(result, manifest->tasks[t].id);
        if (json_object_set_new(scores, manifest->tasks[t].id, json_integer(sum.points)) != 0) {
            json_decref(scores);
            return NULL;
        }
    }
    return json_pack("{s:o, s:[i]}", "scores", scores, "scoreboard", result->score);
}

int report_autolab(const char *path, const Manifest *manifest, const Result *result)
{
    json_t *lines[] = {feedback_json(manifest, result), scores_json(manifest, result)};
    OutputFile output;
    int status = output_file_open(&output, path);
    int written = status == 0;
    for (int i = 0; i < 2; i++) {
        written = written && json_dumpf(lines[i], output.file, JSON_COMPACT) == 0;
        if (written) {
            fputc('\n', output.file);
        }
        json_decref(lines[i]);
    }
    if (status == 0 && !written) {
        output_file_discard(&output);
        complain("%s: cannot write", path);
        status = -1;
    }
    return status == 0 ? output_file_commit(&output) : -1;
}
