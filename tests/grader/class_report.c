// class_report OUT.html TITLE LABEL=results.json ...: one page over a whole class, a row a
// submission.
//
// Each row links to the report.html beside its results.json, so the page and the reports can be
// moved together. "LABEL=" without a file is a submission that was not graded: the machinery failed
// there, and that must not look like a zero. Exit status: 0, 1 when the page cannot be written, 2
// for bad input (after one message). Flow: results of many submissions -> ONE PAGE. Read next:
// graded.c.
#include "graded.h"
#include "html.h"
#include "link.h"
#include "output_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Row {
    char *label;       // the submission's name
    const char *path;  // of its results.json; "" when it was not graded
    Graded graded;
} Row;

typedef struct ClassReport {
    const char *out_path;
    const char *title;
    Row *rows;
    int n_rows;
    const Row *first_graded;  // gives the columns; NULL when none was graded
} ClassReport;

// ---- Reading -----------------------------------------------------------------------------------

static int same_columns(const Graded *one, const Graded *other)
{
    int same = strcmp(one->lab, other->lab) == 0 && one->n_tasks == other->n_tasks;
    for (int i = 0; same && i < one->n_tasks; i++) {
        same = strcmp(one->tasks[i].id, other->tasks[i].id) == 0 &&
               one->tasks[i].max_points == other->tasks[i].max_points;
    }
    return same;
}

static int row_read(ClassReport *class, const char *argument)
{
    const char *equals = strchr(argument, '=');
    if (equals == NULL || equals == argument) {
        fprintf(stderr, "class_report: found \"%s\", expected LABEL=results.json\n", argument);
        return -1;
    }
    Row *row = &class->rows[class->n_rows++];
    row->label = strndup(argument, (size_t)(equals - argument));
    row->path = equals + 1;
    if (row->label == NULL) {
        fprintf(stderr, "class_report: out of memory\n");
        return -1;
    }
    if (row->path[0] == '\0') {
        return 0;
    }
    if (graded_load(row->path, &row->graded) != 0) {
        return -1;
    }
    if (class->first_graded == NULL) {
        class->first_graded = row;
    }
    if (!same_columns(&class->first_graded->graded, &row->graded)) {
        fprintf(stderr, "%s: not the lab and the tasks of %s\n", row->path,
                class->first_graded->path);
        return -1;
    }
    return 0;
}

static void class_free(ClassReport *class)
{
    for (int i = 0; i < class->n_rows; i++) {
        free(class->rows[i].label);
        graded_free(&class->rows[i].graded);
    }
    free(class->rows);
}

// ---- Writing -----------------------------------------------------------------------------------

static int scores_compare(const void *left, const void *right)
{
    int a = *(const int *)left;
    int b = *(const int *)right;
    return (a > b) - (a < b);
}

// Write the row's label as a link to its report.html, or without a link when there is none.
static void label_write(FILE *page, const ClassReport *class, const Row *row)
{
    char *link =
        row->path[0] != '\0' ? link_beside(class->out_path, row->path, "report.html") : NULL;
    if (link != NULL) {
        fprintf(page, "<a href=\"%s\">", link);
    }
    html_line(page, row->label);
    if (link != NULL) {
        fputs("</a>", page);
    }
    free(link);
}

static void summary_write(FILE *page, const ClassReport *class)
{
    int *scores = malloc(sizeof *scores * (size_t)class->n_rows);
    int n_graded = 0;
    int n_full = 0;
    double sum = 0;
    for (int i = 0; scores != NULL && i < class->n_rows; i++) {
        const Graded *graded = &class->rows[i].graded;
        if (graded->json == NULL) {
            continue;
        }
        scores[n_graded++] = graded->score;
        sum += graded->score;
        n_full += graded->score == graded->max_score;
    }
    fprintf(page, "<dl class=\"facts\">\n<div><dt>Submissions</dt><dd>%d</dd></div>\n",
            class->n_rows);
    if (n_graded < class->n_rows) {
        fprintf(page, "<div><dt>Not graded</dt><dd class=\"short\">%d</dd></div>\n",
                class->n_rows - n_graded);
    }
    if (n_graded > 0) {
        qsort(scores, (size_t)n_graded, sizeof *scores, scores_compare);
        double median = (scores[(n_graded - 1) / 2] + scores[n_graded / 2]) / 2.0;
        fprintf(page,
                "<div><dt>Mean</dt><dd>%.1f</dd></div>\n<div><dt>Median</dt><dd>%.4g</dd></div>\n"
                "<div><dt>Full marks</dt><dd>%d</dd></div>\n",
                sum / n_graded, median, n_full);
    }
    fputs("</dl>\n", page);
    free(scores);
}

static void table_head_write(FILE *page, const Graded *columns)
{
    fputs("<thead><tr><th>Submission</th><th class=\"number\">Score</th>", page);
    for (int i = 0; i < columns->n_tasks; i++) {
        fputs("<th class=\"number\" title=\"", page);
        html_line(page, columns->tasks[i].title);
        fputs("\">", page);
        html_line(page, columns->tasks[i].id);
        fprintf(page, "<br>of %d</th>", columns->tasks[i].max_points);
    }
    fputs("<th>First fault</th></tr></thead>\n", page);
}

static void fault_write(FILE *page, const char *title, const char *message)
{
    fputs("<b>", page);
    html_line(page, title);
    fputs("</b>\n<p class=\"message\">", page);
    html_line(page, message);
    fputs("</p>", page);
}

// What went wrong first: in a stage, which keeps all checks from running, or in a check.
static void first_fault_write(FILE *page, const Graded *graded)
{
    if (graded->failed_stage != NULL) {
        fault_write(page, graded->failed_stage, graded->stage_message);
        return;
    }
    for (int i = 0; i < graded->n_checks; i++) {
        const GradedCheck *check = &graded->checks[i];
        if (check->status != CHECK_PASSED) {
            fault_write(page, check->title, check->message);
            return;
        }
    }
}

static void row_write(FILE *page, const ClassReport *class, const Row *row)
{
    const Graded *graded = &row->graded;
    fputs("<tr><td class=\"name\">", page);
    label_write(page, class, row);
    if (graded->json == NULL) {
        int n_columns = 2 + (class->first_graded ? class->first_graded->graded.n_tasks : 0);
        fprintf(page, "</td><td colspan=\"%d\" class=\"short\">not graded</td></tr>\n", n_columns);
        return;
    }
    fprintf(page, "</td><td class=\"number\"><b>%d</b> / %d", graded->score, graded->max_score);
    html_score_bar(page, graded->score, graded->max_score);
    fputs("</td>", page);
    for (int i = 0; i < graded->n_tasks; i++) {
        const GradedTask *task = &graded->tasks[i];
        fprintf(page, "<td class=\"number task%s\" data-task=\"",
                task->points < task->max_points ? " short" : "");
        html_line(page, task->id);
        fprintf(page, "\">%d</td>", task->points);
    }
    fputs("<td class=\"first\">", page);
    first_fault_write(page, graded);
    fputs("</td></tr>\n", page);
}

static void check_counts_write(FILE *page, const ClassReport *class)
{
    const Graded *columns = &class->first_graded->graded;
    fputs("<h2 class=\"section\">How many passed each check</h2>\n<div class=\"card\">\n", page);
    for (int i = 0; i < columns->n_checks; i++) {
        int n_passed = 0;
        int n_graded = 0;
        for (int j = 0; j < class->n_rows; j++) {
            const Graded *graded = &class->rows[j].graded;
            n_graded += graded->json != NULL;
            for (int k = 0; k < graded->n_checks; k++) {
                n_passed += strcmp(graded->checks[k].id, columns->checks[i].id) == 0 &&
                            graded->checks[k].status == CHECK_PASSED;
            }
        }
        fputs("<div class=\"count\"><div>", page);
        html_line(page, columns->checks[i].title);
        fputs(" <code class=\"soft\">", page);
        html_line(page, columns->checks[i].id);
        fputs("</code></div>", page);
        html_score_bar(page, n_passed, n_graded);
        fprintf(page, "<span class=\"number\">%d of %d</span></div>\n", n_passed, n_graded);
    }
    fputs("</div>\n", page);
}

static int class_write(const ClassReport *class)
{
    OutputFile output;
    if (output_file_open(&output, class->out_path) != 0) {
        return -1;
    }
    FILE *page = output.file;
    static const Graded no_columns = {0};
    const Graded *columns = class->first_graded ? &class->first_graded->graded : &no_columns;
    html_page_begin(page, class->title);
    fputs("<header>\n<p class=\"lab\">", page);
    html_line(page, columns->lab != NULL ? columns->lab : "");
    fputs("</p>\n<h1>", page);
    html_line(page, class->title);
    fputs("</h1>\n", page);
    summary_write(page, class);
    fputs("</header>\n<div class=\"card\"><table>\n", page);
    table_head_write(page, columns);
    fputs("<tbody>\n", page);
    for (int i = 0; i < class->n_rows; i++) {
        row_write(page, class, &class->rows[i]);
    }
    fputs("</tbody>\n</table></div>\n", page);
    if (class->first_graded != NULL) {
        check_counts_write(page, class);
    }
    html_page_end(page);
    return output_file_commit(&output);
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fprintf(stderr, "usage: class_report OUT.html TITLE LABEL=results.json ...\n");
        return 2;
    }
    ClassReport class = {.out_path = argv[1], .title = argv[2]};
    class.rows = calloc((size_t)argc, sizeof *class.rows);
    int status = class.rows == NULL ? 1 : 0;
    for (int i = 3; i < argc && status == 0; i++) {
        status = row_read(&class, argv[i]) == 0 ? 0 : 2;
    }
    if (status == 0 && class_write(&class) != 0) {
        status = 1;
    }
    class_free(&class);
    return status;
}
