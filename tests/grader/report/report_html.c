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
    return status == CHECK_PASSED ? "&#10003;" : status == CHECK_FAILED ? "&#10007;" : "&ndash;";
}

static void fact_write(FILE *page, const char *name, const char *value)
{
    if (value[0] == '\0') {
        return;
    }
    fprintf(page, "<div><dt>%s</dt><dd>", name);
    html_line(page, value);
    fputs("</dd></div>\n", page);
}

// How it went in one sentence, with a link to where to go on.
static void summary_write(FILE *page, const Result *result)
{
    const CheckResult *first_failed = NULL;
    int n_passed = 0;
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        n_passed += check->status == CHECK_PASSED;
        if (check->status == CHECK_FAILED && first_failed == NULL) {
            first_failed = check;
        }
    }
    const StageResult *failed_stage = NULL;
    for (int i = result->n_stages - 1; i >= 0; i--) {
        failed_stage = result->stages[i].status == CHECK_FAILED ? &result->stages[i] : failed_stage;
    }
    fprintf(page, "<p class=\"soft\">%d of %d checks passed", n_passed, result->n_checks);
    if (first_failed != NULL) {
        fputs("; go on with <a href=\"#", page);
        html_line(page, first_failed->id);
        fputs("\">", page);
        html_line(page, first_failed->title);
        fputs("</a>", page);
    } else if (failed_stage != NULL && n_passed < result->n_checks) {
        fputs("; stopped at: ", page);
        html_line(page, failed_stage->title);
    }
    fputs("</p>\n", page);
}

static void leaderboard_write(FILE *page, const Manifest *manifest, const Result *result)
{
    if (result->leaderboard == 0) {
        return;
    }
    fprintf(page, "<p class=\"soft\"><b class=\"number\">%.1f</b> ", result->leaderboard);
    html_line(page, manifest->leaderboard);
    fputs(REPORT_RACE_NOTE "</p>\n", page);
}

static void head_write(FILE *page, const Manifest *manifest, const Result *result)
{
    fputs("<header>\n<div class=\"head\"><div><p class=\"lab\">", page);
    html_line(page, result->lab);
    fputs("</p>\n<h1>", page);
    html_line(page, result->title);
    fprintf(page,
            "</h1></div>\n<p class=\"score number\">%d <small>of %d points</small></p></div>\n",
            result->score, result->max_score);
    html_score_bar(page, result->score, result->max_score);
    summary_write(page, result);
    leaderboard_write(page, manifest, result);
    char seed[24];
    char seconds[32];
    snprintf(seed, sizeof seed, "%" PRIu64, result->seed);
    snprintf(seconds, sizeof seconds, "%.1f s", result->seconds);
    fputs("<dl class=\"facts\">\n", page);
    fact_write(page, "Submission", result->submission);
    fact_write(page, "Device", result->device);
    fact_write(page, "Sandbox", result->sandbox);
    fact_write(page, "Seed of the hidden scenes", seed);
    fact_write(page, "Graded in", seconds);
    fputs("</dl>\n</header>\n", page);
}

// Stages that went well and have nothing to say are left out: they are no news.
static void stages_write(FILE *page, const Result *result)
{
    int n_written = 0;
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        int has_message = stage->message != NULL && stage->message[0] != '\0';
        if (stage->status == CHECK_PASSED && !has_message) {
            continue;
        }
        if (n_written++ == 0) {
            fputs("<section class=\"card stages\">\n", page);
        }
        fprintf(page,
                "<div class=\"check %s\"><span class=\"mark\">%s</span><div><span class=\"name\">",
                check_status_name(stage->status),
                stage->status == CHECK_PASSED ? "•" : status_mark(stage->status));
        html_line(page, stage->title);
        fprintf(page, "</span></div><span class=\"number\">%s</span>\n",
                stage->status == CHECK_PASSED   ? "note"
                : stage->status == CHECK_FAILED ? "failed"
                                                : "not run");
        html_message(page, stage->message);
        fputs("</div>\n", page);
    }
    if (n_written > 0) {
        fputs("</section>\n", page);
    }
}

static void check_write(FILE *page, const CheckResult *check)
{
    const CheckStatus shown = check_status_shown(check);
    const char *status = check_status_name(shown);
    fprintf(page, "<div class=\"check %s\" id=\"", status);
    html_line(page, check->id);
    fprintf(page, "\"><span class=\"mark\" role=\"img\" aria-label=\"%s\">%s</span>", status,
            status_mark(shown));
    fputs("<div><span class=\"name\">", page);
    html_line(page, check->title);
    fputs("</span> <code class=\"id\">", page);
    html_line(page, check->id);
    fprintf(page, "</code></div><span class=\"number\">%d / %d</span>\n", check->points,
            check->max_points);
    html_message(page, check_message_shown(check));
    fputs("</div>\n", page);
}

static void task_write(FILE *page, const Manifest *manifest, const Task *task, const Result *result)
{
    TaskPoints sum = result_task_points(result, task->id);
    fputs("<section class=\"card\">\n<div class=\"title\"><h2>", page);
    html_line(page, task->title);
    fprintf(page, "</h2><b class=\"number\">%d / %d</b></div>\n<p class=\"soft\">Task <code>",
            sum.points, sum.max_points);
    html_line(page, task->id);
    fputs("</code> in <code>", page);
    html_line(page, task->file);
    fputs("</code></p>\n", page);
    html_score_bar(page, sum.points, sum.max_points);
    for (int i = 0; i < result->n_checks; i++) {
        if (strcmp(result->checks[i].task, task->id) == 0) {
            check_write(page, &result->checks[i]);
        }
    }
    const char *hint = task_hint(manifest, result, task);
    if (hint[0] != '\0') {
        fputs("<p class=\"hint\"><b>Hint</b> ", page);
        html_line(page, hint);
        fputs("</p>\n", page);
    }
    fputs("</section>\n", page);
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
        fputs("<h2 class=\"section\">Pictures</h2>\n", page);
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
