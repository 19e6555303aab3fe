// The report for the terminal (see report.h).
//
// A line a check, so that a student sees at a glance what to do next; messages and hints only where
// something failed. Read next: report_html.c.
#include "report.h"

#include "clean_text.h"
#include "hints.h"
#include "message.h"
#include "utf8.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum {
    PAGE_COLUMNS = 96,
    MESSAGE_INDENT = 9,  // messages begin below the id of their check
};

typedef struct TextReport {
    FILE *out;
    int colours;
    int id_columns;  // the longest id, so that the points stand below each other
} TextReport;

static const char *colour(const TextReport *report, const char *code)
{
    return report->colours ? code : "";
}

#define BOLD "\033[1m"
#define GREEN "\033[32m"
#define RED "\033[31m"
#define GREY "\033[90m"
#define PLAIN "\033[0m"

static const char *status_colour(CheckStatus status)
{
    return status == CHECK_PASSED ? GREEN : status == CHECK_FAILED ? RED : GREY;
}

static const char *status_mark(CheckStatus status)
{
    return status == CHECK_PASSED ? "ok" : status == CHECK_FAILED ? "FAIL" : "--";
}

// Characters of UTF-8, which stand for columns: the bytes that begin one.
static int columns_count(const char *text)
{
    int columns = 0;
    for (; *text != '\0'; text++) {
        columns += !utf8_goes_on(*text);
    }
    return columns;
}

// How many bytes of `line` fit into `columns`: up to the last space that fits, or, of a word longer
// than that, as much as fits.
static size_t bytes_that_fit(const char *line, size_t n_bytes, int columns)
{
    size_t last_space = 0;
    int column = 0;
    for (size_t i = 0; i < n_bytes; i++) {
        if (utf8_goes_on(line[i])) {
            continue;
        }
        if (line[i] == ' ' && column <= columns) {
            last_space = i;
        }
        if (column == columns) {
            return last_space > 0 ? last_space : i;
        }
        column++;
    }
    return n_bytes;
}

static void line_wrap(FILE *out, const char *line, size_t n_bytes)
{
    do {
        size_t fitting = bytes_that_fit(line, n_bytes, PAGE_COLUMNS - MESSAGE_INDENT);
        fprintf(out, "%*s%.*s\n", MESSAGE_INDENT, "", (int)fitting, line);
        while (fitting < n_bytes && line[fitting] == ' ') {
            fitting++;
        }
        line += fitting;
        n_bytes -= fitting;
    } while (n_bytes > 0);
}

// A log is kept line by line, as its carets point at columns; prose is wrapped.
typedef enum MessageKind { MESSAGE_PROSE, MESSAGE_LOG } MessageKind;

static void message_print(FILE *out, const char *message, MessageKind kind)
{
    char *clean = message_clean(message);
    for (const char *line = clean; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        if (length == 0) {
            fputc('\n', out);
        } else if (kind == MESSAGE_PROSE) {
            line_wrap(out, line, length);
        } else {
            fprintf(out, "%*s%.*s\n", MESSAGE_INDENT, "", (int)length, line);
        }
        line += length + (line[length] == '\n');
    }
    free(clean);
}

// All on one line where it fits, else seed and device below, and the submission below those: paths
// and devices' names may be long.
static void head_print(const TextReport *report, const Result *result)
{
    char *device = line_clean(result->device);
    char *submission = line_clean(result->submission);
    fprintf(report->out, "%s%s%s  %s", colour(report, BOLD), result->lab, colour(report, PLAIN),
            result->title);
    char seed[32];
    snprintf(seed, sizeof seed, "seed %" PRIu64, result->seed);
    int columns = columns_count(result->lab) + 2 + columns_count(result->title) +
                  columns_count(seed) + columns_count(", device , sandbox , submission ") +
                  columns_count(device) + columns_count(result->sandbox) +
                  columns_count(submission);
    if (columns + 2 <= PAGE_COLUMNS) {
        fprintf(report->out, "%*s%s, device %s, sandbox %s, submission %s\n",
                PAGE_COLUMNS - columns, "", seed, device, result->sandbox, submission);
    } else {
        fprintf(report->out, "\n %s, device %s, sandbox %s\n submission %s\n", seed, device,
                result->sandbox, submission);
    }
    free(device);
    free(submission);
}

static void stage_print(const TextReport *report, const StageResult *stage)
{
    int has_message = stage->message != NULL && stage->message[0] != '\0';
    if (stage->status == CHECK_PASSED && !has_message) {
        return;
    }
    // What passed and has something to say is a remark.
    const int is_remark = stage->status == CHECK_PASSED;
    fprintf(report->out, "   %s%-4s%s  %s\n",
            is_remark ? "" : colour(report, status_colour(stage->status)),
            is_remark ? "note" : status_mark(stage->status), colour(report, PLAIN), stage->title);
    int is_log = has_message && strchr(stage->message, '\n') != NULL;
    message_print(report->out, stage->message, is_log ? MESSAGE_LOG : MESSAGE_PROSE);
}

// A check, or a task where it has a line only.
static void row_print(const TextReport *report, CheckStatus status, const char *id, int n_points,
                      int n_most, const char *title)
{
    char points[32];
    snprintf(points, sizeof points, "%d/%d", n_points, n_most);
    fprintf(report->out, "   %s%-4s%s  %-*s  %7s  %s\n", colour(report, status_colour(status)),
            status_mark(status), colour(report, PLAIN), report->id_columns, id, points, title);
}

static void check_print(const TextReport *report, const CheckResult *check)
{
    row_print(report, check_status_shown(check), check->id, check->points, check->max_points,
              check->title);
    message_print(report->out, check_message_shown(check), MESSAGE_PROSE);
}

static void hint_print(const TextReport *report, const char *text)
{
    if (text[0] == '\0') {
        return;
    }
    char *hint = message_new("Hint: %s", text);
    fputs(colour(report, BOLD), report->out);
    message_print(report->out, hint, MESSAGE_PROSE);
    fputs(colour(report, PLAIN), report->out);
    free(hint);
}

// Task, file and title, with the points at the right edge; the title below where it does not fit.
static void task_head_print(const TextReport *report, const Task *task, const TaskPoints *sum)
{
    enum { POINTS_COLUMNS = 8 };
    char points[32];
    snprintf(points, sizeof points, "%d/%d", sum->points, sum->max_points);
    int columns = (int)strlen(" Task  in : ") + columns_count(task->id) +
                  columns_count(task->file) + columns_count(task->title);
    const int is_long = columns > PAGE_COLUMNS - POINTS_COLUMNS;
    if (is_long) {
        columns = (int)strlen("   ") + columns_count(task->title);
    }
    const int gap = PAGE_COLUMNS - columns;
    fprintf(report->out, "\n %sTask %s in %s:%s%s%s%*s\n", colour(report, BOLD), task->id,
            task->file, is_long ? "\n   " : " ", task->title, colour(report, PLAIN),
            gap > POINTS_COLUMNS ? gap : POINTS_COLUMNS, points);
}

static void task_print(const TextReport *report, const Manifest *manifest, const Task *task,
                       const Result *result)
{
    const TaskPoints sum = result_task_points(result, task->id);
    task_head_print(report, task, &sum);
    for (int i = 0; i < result->n_checks; i++) {
        if (strcmp(result->checks[i].task, task->id) == 0) {
            check_print(report, &result->checks[i]);
        }
    }
    hint_print(report, task_hint(manifest, result, task));
}

// ---- One task at a time -------------------------------------------------------------------------

// The worst of what its checks show: failed, not run, passed.
static CheckStatus task_status(const Result *result, const Task *task)
{
    CheckStatus worst = CHECK_PASSED;
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        const CheckStatus status = check_status_shown(check);
        if (strcmp(check->task, task->id) == 0 && status != CHECK_PASSED && worst != CHECK_FAILED) {
            worst = status;
        }
    }
    return worst;
}

// The task that is told whole, or NULL.
static const Task *task_told(const Manifest *manifest, const Result *result, ReportTold told)
{
    for (int i = 0; i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        if (told.task != NULL ? strcmp(task->id, told.task) == 0
                              : task_status(result, task) == CHECK_FAILED) {
            return task;
        }
    }
    return NULL;
}

// The first stage that failed, or NULL.
static const char *failed_stage(const Result *result)
{
    for (int i = 0; i < result->n_stages; i++) {
        if (result->stages[i].status == CHECK_FAILED) {
            return result->stages[i].title;
        }
    }
    return NULL;
}

// The one thing to do next: what does not compile, then a task that failed or is not answered, then
// what else went wrong. If there is nothing of all this: hand in.
static void next_step_print(const TextReport *report, const Manifest *manifest,
                            const Result *result, const Task *task)
{
    const char *stage = failed_stage(result);
    fprintf(report->out, "\n Next: ");
    if (stage != NULL && (task == NULL || strcmp(stage, "Compiling") == 0)) {
        fprintf(report->out, "correct what \"%s\" says above, then grade again\n", stage);
    } else if (task != NULL) {
        fprintf(report->out, "%s in %s\n", task->id, task->file);
    } else {
        fprintf(report->out, "nothing is missing; hand in");
        for (int i = 0; i < manifest->n_files; i++) {
            const char *before = i == 0 ? "" : i + 1 < manifest->n_files ? "," : " and";
            fprintf(report->out, "%s %s", before, manifest->files[i]);
        }
        fputc('\n', report->out);
    }
}

// A line a task in the order of work, and all of one.
static void tasks_print(TextReport *report, const Manifest *manifest, const Result *result,
                        ReportTold told)
{
    const Task *whole = task_told(manifest, result, told), *next = NULL, *open = NULL;
    int n_more = 0;
    fputc('\n', report->out);
    for (int i = 0; i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        const CheckStatus status = task_status(result, task);
        const TaskPoints sum = result_task_points(result, task->id);
        row_print(report, status, task->id, sum.points, sum.max_points, task->title);
        if (task != whole && status == CHECK_FAILED) {
            next = next != NULL ? next : task;
            n_more++;
        }
        open = open == NULL && status == CHECK_NOT_RUN ? task : open;
    }
    if (whole != NULL) {
        task_print(report, manifest, whole, result);
    }
    if (n_more > 0) {
        fprintf(report->out, "\n %d more task%s; TASK=%s shows %s, ALL=1 everything\n", n_more,
                n_more == 1 ? " fails" : "s fail", next->id, n_more == 1 ? "it" : "one");
    }
    const int is_wrong = whole != NULL && task_status(result, whole) == CHECK_FAILED;
    next_step_print(report, manifest, result, is_wrong ? whole : next != NULL ? next : open);
}

void report_text(FILE *out, const Manifest *manifest, const Result *result, ReportTold told,
                 int colours)
{
    TextReport report = {.out = out, .colours = colours};
    for (int i = 0; i < result->n_checks; i++) {
        int length = (int)strlen(result->checks[i].id);
        report.id_columns = length > report.id_columns ? length : report.id_columns;
    }
    for (int i = 0; !told.is_all && i < manifest->n_tasks; i++) {
        int length = (int)strlen(manifest->tasks[i].id);
        report.id_columns = length > report.id_columns ? length : report.id_columns;
    }
    head_print(&report, result);
    for (int i = 0; i < result->n_stages; i++) {
        stage_print(&report, &result->stages[i]);
    }
    if (!told.is_all) {
        tasks_print(&report, manifest, result, told);
    }
    for (int i = 0; told.is_all && i < manifest->n_tasks; i++) {
        task_print(&report, manifest, &manifest->tasks[i], result);
    }
    fprintf(out, "\n %sScore %d/%d%s\n", colour(&report, BOLD), result->score, result->max_score,
            colour(&report, PLAIN));
    fflush(out);
}

int report_text_end(FILE *out, const Manifest *manifest, const Result *result, const char *path)
{
    if (result->leaderboard != 0) {
        char *counts = line_clean(manifest->leaderboard);
        fprintf(out, " %.1f %s" REPORT_RACE_NOTE "\n", result->leaderboard, counts);
        free(counts);
    }
    fprintf(out, "Report: %s\n", path);
    if (fflush(out) != 0 || ferror(out)) {
        fprintf(stderr, "report: cannot write the text report\n");
        return -1;
    }
    return 0;
}
