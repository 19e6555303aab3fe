// PrairieLearn's results.json (see report_systems.h).
//
// A submission that could not be judged at all, as a file is missing or nothing compiles, is "not
// gradable": PrairieLearn then shows why and takes no attempt. So is, for another reason, a fault
// of the machinery. The points of a test are the check's; the score is their share, from 0 to 1.
// Flow: judging -> result -> REPORTS. Read next: json_pictures.c.
#include "json_pictures.h"
#include "json_text.h"
#include "report_systems.h"
#include "report_words.h"

#include <stdlib.h>
#include <string.h>

// "This file should be limited to 1 MB", in the documentation's words; a MB in its smaller sense.
#define MAX_FILE_BYTES ((size_t)1000 * 1000)

static json_t *test_json(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const Task *task = manifest_task(manifest, check->task);
    char *words = check_words(manifest, result, check);
    json_t *json =
        json_pack("{s:o, s:o, s:i, s:i, s:o}", "name", json_line(check->title), "description",
                  json_line(task != NULL ? task->title : check->task), "points", check->points,
                  "max_points", check->max_points, "message", json_message(words));
    free(words);
    return json;
}

static json_t *tests_json(const Manifest *manifest, const Result *result)
{
    json_t *tests = json_array();
    for (int i = 0; i < result->n_checks; i++) {
        json_t *test = test_json(manifest, result, &result->checks[i]);
        if (json_array_append_new(tests, test) != 0) {
            json_decref(tests);
            return NULL;
        }
    }
    return tests;
}

// Was nothing run, because the files were not all there or not one answer compiled?
static int is_gradable(const Result *result)
{
    const StageResult *failed = failed_stage(result);
    if (failed == NULL || strcmp(failed->title, "Running") == 0) {
        return 1;
    }
    for (int i = 0; i < result->n_checks; i++) {
        if (result->checks[i].status != CHECK_NOT_RUN) {
            return 1;
        }
    }
    return 0;
}

static json_t *document_json(const Manifest *manifest, const Result *result)
{
    const double share = result->max_score > 0 ? (double)result->score / result->max_score : 0;
    char *points = points_words(result->score, result->max_score);
    char *stages = stages_words(result);
    json_t *document = json_pack("{s:b, s:f, s:o, s:o, s:o}", "gradable", 1, "score", share,
                                 "message", json_line(points), "output", json_message(stages),
                                 "tests", tests_json(manifest, result));
    free(stages);
    free(points);
    return document;
}

static json_t *not_gradable_json(const char *why)
{
    return json_pack("{s:b, s:[o]}", "gradable", 0, "format_errors", json_message(why));
}

int report_prairielearn(const char *path, const Manifest *manifest, const Result *result)
{
    if (!is_gradable(result)) {
        return json_save(path, not_gradable_json(failed_stage(result)->message), JSON_COMPACT);
    }
    json_t *document = document_json(manifest, result);
    const size_t n_bytes = json_dumpb(document, NULL, 0, JSON_COMPACT | JSON_REAL_PRECISION(6)) +
                           strlen(",\"images\":[]\n");
    if (document != NULL && n_bytes < MAX_FILE_BYTES) {
        json_t *pictures = json_pictures(result, MAX_FILE_BYTES - n_bytes);
        if (pictures == NULL || json_object_set_new(document, "images", pictures) != 0) {
            json_decref(document);
            return -1;
        }
    }
    return json_save(path, document, JSON_COMPACT);
}

int report_prairielearn_fault(const char *path, const char *lab)
{
    (void)lab;
    return json_save(path, not_gradable_json(FORMATS_FAULT_TEXT), JSON_COMPACT);
}
