// class.html: the class on one page (see gradebook.h).
//
// Streamed from top to bottom: how the class did, what went wrong how often, who is fastest where
// that was measured, a row a submission, and all pictures. It links to the reports below its own
// folder, so that the folder can be moved as a whole. Read next: class_page.h, its parts.
#include "class_page.h"

#include "complain.h"
#include "corrections.h"
#include "html.h"
#include "lateness.h"
#include "output_file.h"
#include "tally.h"

#include <stdlib.h>
#include <string.h>

void class_name_write(FILE *page, const Row *row)
{
    const Entrant *entrant = row->entrant;
    if (row->number > 0) {
        fprintf(page, "No. %d", row->number);
        return;
    }
    const int has_report = row->status != ROW_NOT_GRADED;
    if (has_report) {
        fprintf(page, "<a href=\"students/%s/report.html\">", entrant->slug);
    }
    html_line(page, entrant->label);
    fputs(has_report ? "</a>" : "", page);
    if (entrant->attempt > 1) {
        fprintf(page, " <span class=\"soft\">attempt %d</span>", entrant->attempt);
    }
}

// ---- The head --------------------------------------------------------------------------------

static int scores_compare(const void *left, const void *right)
{
    return *(const int *)left - *(const int *)right;
}

static void fact_write(FILE *page, const char *name, const char *value)
{
    fprintf(page, "<div><dt>%s</dt><dd>%s</dd></div>\n", name, value);
}

static void facts_write(FILE *page, const Gradebook *gradebook)
{
    int *scores = calloc((size_t)gradebook->n_rows + 1, sizeof *scores);
    int n = 0;  // those that count: an earlier attempt is no other student's
    int n_graded = 0;
    int n_full = 0;
    double sum = 0;
    for (int i = 0; scores != NULL && i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n_graded += row_is_graded(row);
        if (row_is_counted(gradebook, row)) {
            scores[n++] = row->score;
            sum += row->score;
            n_full += row->score == gradebook->max_score;
        }
    }
    char value[64];
    fputs("<dl class=\"facts\">\n", page);
    snprintf(value, sizeof value, "%d", gradebook->n_rows);
    fact_write(page, "Submissions", value);
    if (n_graded + gradebook->n_nothing < gradebook->n_rows) {
        fprintf(page, "<div><dt>Not graded</dt><dd class=\"short\">%d</dd></div>\n",
                gradebook->n_rows - n_graded - gradebook->n_nothing);
    }
    if (n > 0) {
        qsort(scores, (size_t)n, sizeof *scores, scores_compare);
        snprintf(value, sizeof value, "%.1f", sum / n);
        fact_write(page, "Mean", value);
        snprintf(value, sizeof value, "%.4g", (scores[(n - 1) / 2] + scores[n / 2]) / 2.0);
        fact_write(page, "Median", value);
        snprintf(value, sizeof value, "%d", n_full);
        fact_write(page, "Full marks", value);
    }
    fputs("</dl>\n", page);
    free(scores);
}

//   tally   NULL on the page without names, which is not for those who have something to decide
static void head_write(FILE *page, const Gradebook *gradebook, const Tally *tally,
                       int has_leaderboard)
{
    fputs("<header>\n<p class=\"lab\">", page);
    html_line(page, gradebook->lab != NULL ? gradebook->lab : "");
    fputs("</p>\n<h1>", page);
    html_line(page, gradebook->title != NULL ? gradebook->title : "");
    fputs(": the class</h1>\n", page);
    if (tally != NULL) {
        fputs("<p>", page);
        tally_write(page, tally);
        fputs(".</p>\n", page);
    }
    facts_write(page, gradebook);
    class_histogram_write(page, gradebook);
    fprintf(page,
            "<nav><a href=\"#failures\">What went wrong</a> <a href=\"#tasks\">Tasks</a> "
            "<a href=\"#checks\">Checks</a> %s"
            "<a href=\"#table\">Every submission</a>%s</nav>\n"
            "</header>\n",
            has_leaderboard ? "<a href=\"#leaderboard\">Leaderboard</a> " : "",
            tally != NULL ? " <a href=\"#gallery\">Pictures</a>" : "");
}

// A row of a list before the table: whose it is, and why it is listed.
static void listed_write(FILE *page, const Row *row, const char *why)
{
    fputs("<tr><td class=\"name\">", page);
    class_name_write(page, row);
    fputs("</td><td class=\"first\">", page);
    html_line(page, why);
    if (row->has_log) {
        fprintf(page, " <a href=\"logs/%s.txt\">what the grader said</a>", row->entrant->slug);
    }
    fputs("</td></tr>\n", page);
}

// What no check has judged, so that a score would say nothing.
static void nothing_write(FILE *page, const Gradebook *gradebook)
{
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->status != ROW_NOTHING || row_that_counts(gradebook, row) != row) {
            continue;
        }
        if (n++ == 0) {
            fprintf(page,
                    "<h2 class=\"section\" id=\"nothing\">Nothing of this lab</h2>\n"
                    "<p class=\"soft\">These entries hold no file of the lab, or none that can be "
                    "read. The gradebooks have %s for them (NOTHING=0 or NOTHING=blank).</p>\n"
                    "<div class=\"card\"><table><tbody>\n",
                    gradebook->nothing_is_zero ? "a zero" : "a blank");
        }
        listed_write(page, row, row->reason);
    }
    fputs(n > 0 ? "</tbody></table></div>\n" : "", page);
}

// Entries that were entered for nobody, or not for all of a team, or without a grade.
static void undecided_write(FILE *page, const Gradebook *gradebook, const Worksheet *worksheet)
{
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const char *why = tally_why_undecided(gradebook, worksheet, row);
        if (why == NULL) {
            continue;
        }
        if (n++ == 0) {
            fputs(
                "<h2 class=\"section\" id=\"undecided\">To be decided by you</h2>\n"
                "<p class=\"soft\">It is not certain who handed these in, or when. So no grade is "
                "entered. <code>who.csv</code>, in this folder or where you gave it, has a line "
                "for each: write the student, or the time under <code>handed in</code>, and give "
                "the file as <code>WHO=</code>.</p>\n"
                "<div class=\"card\"><table><tbody>\n",
                page);
        }
        listed_write(page, row, why);
    }
    fputs(n > 0 ? "</tbody></table></div>\n" : "", page);
}

static void passed_over_write(FILE *page, const Roster *roster)
{
    if (roster->n_passed_over == 0) {
        return;
    }
    fputs(
        "<h2 class=\"section\" id=\"passed-over\">Passed over</h2>\n"
        "<p class=\"soft\">Files of which no name says whose they are. If one is a student's, put "
        "it into a folder with the student's name. A list of a course system's name among them may "
        "be a student's, so it decides nothing.</p>\n<div class=\"card\"><p class=\"names\">",
        page);
    for (int i = 0; i < roster->n_passed_over; i++) {
        fputs(i > 0 ? " &middot; " : "", page);
        html_line(page, roster->passed_over[i]);
    }
    fputs("</p></div>\n", page);
}

// Apart from all others: nobody has judged these, and nobody may read a zero.
static void not_graded_write(FILE *page, const Gradebook *gradebook)
{
    if (gradebook->n_graded + gradebook->n_nothing == gradebook->n_rows) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"not-graded\">Not graded</h2>\n"
          "<p class=\"soft\">The grader itself could not work here. That is no zero: run the same "
          "command again, it takes up only these.</p>\n<div class=\"card\"><table><tbody>\n",
          page);
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->status == ROW_NOT_GRADED) {
            listed_write(page, row, row->reason);
        }
    }
    fputs("</tbody></table></div>\n", page);
}

// ---- The table -------------------------------------------------------------------------------

static void table_head_write(FILE *page, const Gradebook *gradebook)
{
    fputs("<thead><tr><th>Submission</th><th class=\"number\">Score</th>", page);
    if (gradebook->has_old_scores) {
        fputs("<th class=\"number\">Before</th>", page);
    }
    for (int i = 0; i < gradebook->n_tasks; i++) {
        fputs("<th class=\"number\" title=\"", page);
        html_line(page, gradebook->tasks[i].title);
        fputs("\">", page);
        html_line(page, gradebook->tasks[i].id);
        fprintf(page, "<br>of %d</th>", gradebook->tasks[i].max_points);
    }
    fputs("<th>First fault</th></tr></thead>\n", page);
}

static void old_score_write(FILE *page, const Row *row)
{
    fputs("<td class=\"number before\">", page);
    if (row->has_old_score) {
        const int change = row->score - row->old_score;
        fprintf(page, "%d", row->old_score);
        if (change != 0) {
            fprintf(page, " <b class=\"%s\">%+d</b>", change < 0 ? "short" : "gain", change);
        }
    } else {
        fputs("&ndash;", page);
    }
    fputs("</td>", page);
}

static void row_write(FILE *page, const Gradebook *gradebook, const Row *row)
{
    if (row->number > 0) {
        fputs("<tr><td class=\"name\">", page);
    } else {
        fprintf(page, "<tr id=\"%s\"><td class=\"name\">", row->entrant->slug);
    }
    class_name_write(page, row);
    if (row->status == ROW_OUTDATED) {
        fputs(" <span class=\"soft\">outdated</span>", page);
    }
    if (corrections_has(gradebook, row)) {
        fputs(" <a class=\"soft\" href=\"#corrections\">corrected</a>", page);
    }
    if (lateness_is_late(lateness_of(gradebook, row))) {
        fputs(" <a class=\"soft\" href=\"#late\">late</a>", page);
    }
    if (row->time_unknown != NULL) {
        fputs(" <a class=\"soft\" href=\"#undecided\">to be decided</a>", page);
    }
    fprintf(page, "</td><td class=\"number\"><b>%d</b> / %d", row->score, gradebook->max_score);
    html_score_bar(page, row->score, gradebook->max_score);
    fputs("</td>", page);
    if (gradebook->has_old_scores) {
        old_score_write(page, row);
    }
    for (int i = 0; i < gradebook->n_tasks; i++) {
        const Column *task = &gradebook->tasks[i];
        fprintf(page, "<td class=\"number task%s\" data-task=\"",
                row->points[i] < task->max_points ? " short" : "");
        html_line(page, task->id);
        fprintf(page, "\">%d</td>", row->points[i]);
    }
    fputs("<td class=\"first\">", page);
    if (row->fault != NULL) {
        fputs("<b>", page);
        html_line(page, row->fault);
        fputs("</b>\n<p class=\"message\">", page);
        html_line(page, row->fault_message);
        fputs("</p>", page);
    }
    fputs("</td></tr>\n", page);
}

static void table_write(FILE *page, const Gradebook *gradebook)
{
    if (gradebook->n_graded == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"table\">Every submission</h2>\n<div class=\"card\"><table>\n",
          page);
    table_head_write(page, gradebook);
    fputs("<tbody>\n", page);
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (row_is_graded(&gradebook->rows[i])) {
            row_write(page, gradebook, &gradebook->rows[i]);
        }
    }
    fputs("</tbody>\n</table></div>\n", page);
}

// ---- The page --------------------------------------------------------------------------------

static void page_write(FILE *page, const Gradebook *gradebook, const Failures *failures,
                       const LookAlikes *look_alikes, const Leaderboard *leaderboard,
                       const Worksheet *worksheet)
{
    const Tally tally = tally_count(gradebook, worksheet, look_alikes->n_groups);
    const int has_names = !gradebook->has_no_names;
    char title[256];
    snprintf(title, sizeof title, "%s: the class", gradebook->lab != NULL ? gradebook->lab : "");
    html_album_begin(page, title);
    head_write(page, gradebook, has_names ? &tally : NULL, leaderboard->n_places > 0);
    if (has_names) {
        nothing_write(page, gradebook);
        undecided_write(page, gradebook, worksheet);
        passed_over_write(page, &gradebook->roster);
        not_graded_write(page, gradebook);
        class_look_alikes_write(page, look_alikes);
        class_corrections_write(page, gradebook);
        class_late_write(page, gradebook);
        class_changes_write(page, gradebook);
    }
    class_failures_write(page, gradebook, failures);
    class_tasks_write(page, gradebook);
    class_checks_write(page, gradebook);
    class_leaderboard_write(page, gradebook, leaderboard);
    table_write(page, gradebook);
    class_gallery_write(page, gradebook);
    html_page_end(page);
}

int gradebook_page(const Gradebook *gradebook, const char *path, const Worksheet *worksheet)
{
    Failures failures = {0};
    LookAlikes look_alikes = {0};
    Leaderboard leaderboard = {0};
    OutputFile output;
    int result = -1;
    if (failures_find(gradebook, &failures) == 0 &&
        look_alikes_find(gradebook, &look_alikes) == 0 &&
        leaderboard_find(gradebook, &leaderboard) == 0 && output_file_open(&output, path) == 0) {
        page_write(output.file, gradebook, &failures, &look_alikes, &leaderboard, worksheet);
        result = output_file_commit(&output);
    }
    failures_free(&failures);
    look_alikes_free(&look_alikes);
    leaderboard_free(&leaderboard);
    return result;
}

// ---- Without names ---------------------------------------------------------------------------

// The best first. Of equal scores the order is that of what the page shows of them, and not that of
// their names.
static int shown_compare(const void *left, const void *right)
{
    const Row *a = left, *b = right;
    int order = row_is_graded(b) - row_is_graded(a);
    order = order != 0 ? order : b->score - a->score;
    order = order != 0 ? order : memcmp(b->passed, a->passed, sizeof a->passed);
    order = order != 0 ? order : memcmp(b->points, a->points, sizeof a->points);
    order = order != 0 ? order : b->old_score - a->old_score;
    order = order != 0 ? order : (int)a->status - (int)b->status;
    order =
        order != 0 ? order : (a->leaderboard < b->leaderboard) - (a->leaderboard > b->leaderboard);
    order = order != 0 ? order : (a->fault != NULL) - (b->fault != NULL);
    if (order == 0 && a->fault != NULL && b->fault != NULL) {
        order = strcmp(a->fault, b->fault);
        order = order != 0 ? order : strcmp(a->fault_message, b->fault_message);
    }
    return order;
}

int gradebook_page_without_names(const Gradebook *gradebook, const char *path)
{
    Gradebook shown = *gradebook;
    shown.rows = calloc((size_t)gradebook->n_rows + 1, sizeof *shown.rows);
    if (shown.rows == NULL) {
        complain("gradebook: %s: out of memory", path);
        return -1;
    }
    shown.n_rows = shown.n_graded = shown.n_nothing = 0;
    shown.has_no_names = 1;
    shown.lateness = NULL;  // who was late is nobody else's business
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row_that_counts(gradebook, row) != row) {
            continue;
        }
        Row *copy = &shown.rows[shown.n_rows++];
        *copy = *row;
        copy->picture = NULL;  // its path has the name
        copy->time_unknown = NULL;
        shown.n_graded += row_is_graded(row);
        shown.n_nothing += row->status == ROW_NOTHING;
        // A stage, such as the compiler, quotes what the student wrote.
        if (row->fault != NULL && (row->fault_id[0] == '\0' || row->is_fault_hidden)) {
            copy->fault_message = "";
        }
    }
    qsort(shown.rows, (size_t)shown.n_rows, sizeof *shown.rows, shown_compare);
    for (int i = 0; i < shown.n_rows; i++) {
        shown.rows[i].number = i + 1;
    }
    const int result = gradebook_page(&shown, path, NULL);
    free(shown.rows);
    return result;
}
