// The report as one self-contained page (see report.h).
//
// The page may be opened by an instructor, beside other students' pages, and quotes code that
// nobody has read: nothing in it runs, nothing is fetched. Read next: html.c, report_pictures.c.
#include "report.h"

#include "hints.h"
#include "html.h"
#include "output_file.h"
#include "report_pictures.h"

#include <inttypes.h>
#include <string.h>

static const char *status_mark(CheckStatus status)
{
    return status == CHECK_PASSED ? "✓" : status == CHECK_FAILED ? "✗" : "–";
}

static void fact_write(FILE *page, const char *name, const char *value)
{
    if (value[0] != '\0') {
        html_write(page, "<div><dt>%s</dt><dd>%s</dd></div>\n", name, value);
    }
}

// How it went in one sentence, with a link to where to go on.
static void summary_write(FILE *page, const Result *result)
{
    const CheckResult *first_failed = NULL;
    const StageResult *failed_stage = NULL;
    int n_passed = 0;
    for (int i = result->n_checks - 1; i >= 0; i--) {
        const CheckResult *check = &result->checks[i];
        n_passed += check->status == CHECK_PASSED;
        first_failed = check->status == CHECK_FAILED ? check : first_failed;
    }
    for (int i = result->n_stages - 1; i >= 0; i--) {
        failed_stage = result->stages[i].status == CHECK_FAILED ? &result->stages[i] : failed_stage;
    }
    html_write(page, "<p class=\"soft\">%d of %d checks passed", n_passed, result->n_checks);
    if (first_failed != NULL) {
        html_write(page, "; go on with <a href=\"#%s\">%s</a>", first_failed->id,
                   first_failed->title);
    } else if (failed_stage != NULL && n_passed < result->n_checks) {
        html_write(page, "; stopped at: %s", failed_stage->title);
    }
    html_write(page, "</p>\n");
}

static void head_write(FILE *page, const Manifest *manifest, const Result *result)
{
    char seed[24], seconds[32];
    html_write(page,
               "<header>\n<div class=\"head\"><div><p class=\"lab\">%s</p>\n<h1>%s</h1></div>\n"
               "<p class=\"score number\">%d <small>of %d points</small></p></div>\n",
               result->lab, result->title, result->score, result->max_score);
    html_score_bar(page, result->score, result->max_score);
    summary_write(page, result);
    if (result->leaderboard != 0) {
        html_write(page,
                   "<p class=\"soft\"><b class=\"number\">%.1f</b> %s" REPORT_RACE_NOTE "</p>\n",
                   result->leaderboard, manifest->leaderboard);
    }
    snprintf(seed, sizeof seed, "%" PRIu64, result->seed);
    snprintf(seconds, sizeof seconds, "%.1f s", result->seconds);
    html_write(page, "<dl class=\"facts\">\n");
    fact_write(page, "Submission", result->submission);
    fact_write(page, "Device", result->device);
    fact_write(page, "Sandbox", result->sandbox);
    fact_write(page, "Seed of the hidden scenes", seed);
    fact_write(page, "Graded in", seconds);
    html_write(page, "</dl>\n</header>\n");
}

// Stages that went well and have nothing to say are left out: they are no news.
static void stages_write(FILE *page, const Result *result)
{
    int n_written = 0;
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        const int is_passed = stage->status == CHECK_PASSED;
        if (is_passed && (stage->message == NULL || stage->message[0] == '\0')) {
            continue;
        }
        if (n_written++ == 0) {
            html_write(page, "<section class=\"card stages\">\n");
        }
        html_write(page,
                   "<div class=\"check %s\"><span class=\"mark\">%s</span><div>"
                   "<span class=\"name\">%s</span></div><span class=\"number\">%s</span>\n",
                   check_status_name(stage->status), is_passed ? "•" : status_mark(stage->status),
                   stage->title,
                   is_passed                       ? "note"
                   : stage->status == CHECK_FAILED ? "failed"
                                                   : "not run");
        html_message(page, stage->message);
        html_write(page, "</div>\n");
    }
    if (n_written > 0) {
        html_write(page, "</section>\n");
    }
}

static void check_write(FILE *page, const CheckResult *check)
{
    const CheckStatus shown = check_status_shown(check);
    const char *status = check_status_name(shown);
    html_write(page,
               "<div class=\"check %s\" id=\"%s\"><span class=\"mark\" role=\"img\" "
               "aria-label=\"%s\">%s</span><div><span class=\"name\">%s</span> "
               "<code class=\"id\">%s</code></div><span class=\"number\">%d / %d</span>\n",
               status, check->id, status, status_mark(shown), check->title, check->id,
               check->points, check->max_points);
    html_message(page, check_message_shown(check));
    html_write(page, "</div>\n");
}

static void task_write(FILE *page, const Manifest *manifest, const Task *task, const Result *result)
{
    const TaskPoints sum = result_task_points(result, task->id);
    const char *hint = task_hint(manifest, result, task);
    html_write(page,
               "<section class=\"card\">\n<div class=\"title\"><h2>%s</h2>"
               "<b class=\"number\">%d / %d</b></div>\n"
               "<p class=\"soft\">Task <code>%s</code> in <code>%s</code></p>\n",
               task->title, sum.points, sum.max_points, task->id, task->file);
    html_score_bar(page, sum.points, sum.max_points);
    for (int i = 0; i < result->n_checks; i++) {
        if (strcmp(result->checks[i].task, task->id) == 0) {
            check_write(page, &result->checks[i]);
        }
    }
    if (hint[0] != '\0') {
        html_write(page, "<p class=\"hint\"><b>Hint</b> %s</p>\n", hint);
    }
    html_write(page, "</section>\n");
}

static int page_write(FILE *page, const Manifest *manifest, const Result *result)
{
    char title[256];
    snprintf(title, sizeof title, "%s: %d/%d", result->lab, result->score, result->max_score);
    html_page_begin(page, title);
    head_write(page, manifest, result);
    stages_write(page, result);
    for (int i = 0; i < manifest->n_tasks; i++) {
        task_write(page, manifest, &manifest->tasks[i], result);
    }
    if (result->n_pictures > 0) {
        html_write(page, "<h2 class=\"section\">Pictures</h2>\n");
    }
    for (int i = 0; i < result->n_pictures; i++) {
        if (report_pictures_write(page, &result->pictures[i]) != 0) {
            return -1;
        }
    }
    html_page_end(page);
    return 0;
}

int report_html(const char *path, const Manifest *manifest, const Result *result)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    if (page_write(output.file, manifest, result) != 0) {
        output_file_discard(&output);
        return -1;
    }
    return output_file_commit(&output);
}
