// Gradescope's results.json (see report_systems.h).
//
// Its tests are passed or failed: a check that did not run is a failed one there, and says so.
// Gradescope escapes text itself; only the pictures are HTML, and their labels are escaped here.
// Nothing is written after a fault of the machinery: without the file Gradescope tells the student
// that the autograder failed, and gives no points.
// Flow: judging -> result -> REPORTS. Read next: json_pictures.c.
#include "html.h"
#include "json_pictures.h"
#include "json_text.h"
#include "report_systems.h"
#include "report_words.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The documentation names no limit; what fits PrairieLearn's is taken here, too.
#define MAX_PICTURE_BYTES ((size_t)400 * 1000)

// "2.1": the check's place among those of its task.
static void number_write(char number[32], const Manifest *manifest, const Result *result, int i)
{
    const char *id = result->checks[i].task;
    const Task *task = manifest_task(manifest, id);
    int place = 1;
    for (int before = 0; before < i; before++) {
        place += strcmp(result->checks[before].task, id) == 0;
    }
    snprintf(number, 32, "%d.%d", task != NULL ? (int)(task - manifest->tasks) + 1 : 0, place);
}

static json_t *test_json(const Manifest *manifest, const Result *result, int i)
{
    const CheckResult *check = &result->checks[i];
    char number[32];
    number_write(number, manifest, result, i);
    char *words = check_words(manifest, result, check);
    json_t *json =
        json_pack("{s:i, s:i, s:s, s:o, s:s, s:o, s:s, s:[o]}", "score", check->points, "max_score",
                  check->max_points, "status", check->status == CHECK_PASSED ? "passed" : "failed",
                  "name", json_line(check->title), "number", number, "output", json_message(words),
                  "output_format", "text", "tags", json_line(check->task));
    free(words);
    return json;
}

// A test without points that shows a picture.
static json_t *picture_json(const json_t *figure)
{
    const char *label = json_string_value(json_object_get(figure, "label"));
    char *html = NULL;
    size_t n_bytes = 0;
    FILE *stream = open_memstream(&html, &n_bytes);
    if (stream == NULL) {
        return NULL;
    }
    fputs("<img alt=\"", stream);
    html_line(stream, label);
    fprintf(stream, "\" src=\"%s\">", json_string_value(json_object_get(figure, "url")));
    json_t *json = NULL;
    if (fclose(stream) == 0) {
        json = json_pack("{s:s, s:s, s:s}", "name", label, "output", html, "output_format", "html");
    }
    free(html);
    return json;
}

static json_t *tests_json(const Manifest *manifest, const Result *result)
{
    json_t *tests = json_array();
    json_t *pictures = json_pictures(result, MAX_PICTURE_BYTES);
    int failed = pictures == NULL;
    for (int i = 0; i < result->n_checks && !failed; i++) {
        failed = json_array_append_new(tests, test_json(manifest, result, i)) != 0;
    }
    for (size_t i = 0; i < json_array_size(pictures) && !failed; i++) {
        failed = json_array_append_new(tests, picture_json(json_array_get(pictures, i))) != 0;
    }
    json_decref(pictures);
    if (failed) {
        json_decref(tests);
        return NULL;
    }
    return tests;
}

int report_gradescope(const char *path, const Manifest *manifest, const Result *result)
{
    if (!isfinite(result->seconds)) {
        return json_save(path, NULL, JSON_COMPACT);
    }
    char seed[24];
    snprintf(seed, sizeof seed, "%" PRIu64, result->seed);
    char *stages = stages_words(result);
    json_t *document =
        json_pack("{s:i, s:i, s:o, s:s, s:o, s:{s:s, s:s, s:o}}", "score", result->score,
                  "execution_time", (int)lround(result->seconds), "output", json_message(stages),
                  "output_format", "text", "tests", tests_json(manifest, result), "extra_data",
                  "lab", result->lab, "seed", seed, "device", json_line(result->device));
    free(stages);
    return json_save(path, document, JSON_COMPACT);
}
