// class.html: the class on one page (see class_page.h).
//
// Its values are gathered here and filled into class.html, the template: how the class did, what
// went wrong how often, who is fastest where that was measured, a row a submission, and all
// pictures. It links to the reports below its own folder, so that the folder can be moved as a
// whole. Read next: class.html; class_parts.c.
#include "class_page.h"

#include "complain.h"
#include "corrections.h"
#include "html.h"
#include "lateness.h"
#include "output_file.h"
#include "tally.h"
#include "template.h"

#include <stdlib.h>
#include <string.h>

TEMPLATE(class_html, "tests/class/pages/class.html");

static void name_write(FILE *page, const void *about)
{
    const Row *row = about;
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

json_t *class_row(const Row *row)
{
    return json_pack("{s:o}", "who", template_markup(name_write, row));
}

// ---- The head --------------------------------------------------------------------------------

static int scores_compare(const void *left, const void *right)
{
    return *(const int *)left - *(const int *)right;
}

__attribute__((format(printf, 4, 5))) static void fact_add(json_t *facts, const char *name,
                                                           int is_short, const char *format, ...)
{
    char value[64];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(value, sizeof value, format, arguments);
    va_end(arguments);
    json_array_append_new(
        facts, json_pack("{s:s, s:s, s:b}", "fact", name, "value", value, "is_short", is_short));
}

static json_t *facts_of(const Gradebook *gradebook)
{
    int *scores = calloc((size_t)gradebook->n_rows + 1, sizeof *scores);
    int n = 0;  // those that count: an earlier attempt is no other student's
    int n_graded = 0, n_full = 0;
    double sum = 0;
    json_t *facts = json_array();
    for (int i = 0; scores != NULL && i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n_graded += row_is_graded(row);
        if (row_is_counted(gradebook, row)) {
            scores[n++] = row->score;
            sum += row->score;
            n_full += row->score == gradebook->max_score;
        }
    }
    fact_add(facts, "Submissions", 0, "%d", gradebook->n_rows);
    if (n_graded + gradebook->n_nothing < gradebook->n_rows) {
        fact_add(facts, "Not graded", 1, "%d", gradebook->n_rows - n_graded - gradebook->n_nothing);
    }
    if (n > 0) {
        qsort(scores, (size_t)n, sizeof *scores, scores_compare);
        fact_add(facts, "Mean", 0, "%.1f", sum / n);
        fact_add(facts, "Median", 0, "%.4g", (scores[(n - 1) / 2] + scores[n / 2]) / 2.0);
        fact_add(facts, "Full marks", 0, "%d", n_full);
    }
    free(scores);
    return facts;
}

static void tally_markup(FILE *file, const void *about)
{
    tally_write(file, about);
}

// ---- Lists before the table ------------------------------------------------------------------

// Why a row is in a list; NULL: it is not.
typedef const char *WhyListed(const Gradebook *gradebook, const Worksheet *worksheet,
                              const Row *row);

// What no check has judged, so that a score would say nothing.
static const char *why_nothing(const Gradebook *gradebook, const Worksheet *worksheet,
                               const Row *row)
{
    (void)worksheet;
    return row->status == ROW_NOTHING && row_that_counts(gradebook, row) == row ? row->reason
                                                                                : NULL;
}

// Apart from all others: nobody has judged these, and nobody may read a zero.
static const char *why_not_graded(const Gradebook *gradebook, const Worksheet *worksheet,
                                  const Row *row)
{
    (void)gradebook, (void)worksheet;
    return row->status == ROW_NOT_GRADED ? row->reason : NULL;
}

static json_t *listed_rows(const Gradebook *gradebook, const Worksheet *worksheet,
                           WhyListed *why_listed)
{
    json_t *rows = json_array();
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const char *why = why_listed(gradebook, worksheet, row);
        if (why != NULL) {
            json_t *listed = class_row(row);
            json_object_set_new(listed, "why", template_line(why));
            if (row->has_log) {
                json_object_set_new(listed, "log", json_string(row->entrant->slug));
            }
            json_array_append_new(rows, listed);
        }
    }
    return rows;
}

static json_t *passed_over_files(const Roster *roster)
{
    json_t *files = json_array();
    for (int i = 0; i < roster->n_passed_over; i++) {
        json_array_append_new(files,
                              json_pack("{s:o}", "file", template_line(roster->passed_over[i])));
    }
    return files;
}

static json_t *lists_of(const Gradebook *gradebook, const Worksheet *worksheet)
{
    const struct {
        const char *id, *title, *what;
        WhyListed *why;  // NULL: it lists files
    } all[] = {
        {"nothing", "Nothing of this lab",
         gradebook->nothing_is_zero
             ? "These entries hold no file of the lab, or none that can be read. The gradebooks "
               "have a zero for them (NOTHING=0 or NOTHING=blank)."
             : "These entries hold no file of the lab, or none that can be read. The gradebooks "
               "have a blank for them (NOTHING=0 or NOTHING=blank).",
         why_nothing},
        // Entered for nobody, or not for all of a team, or without a grade.
        {"undecided", "To be decided by you",
         "It is not certain who handed these in, or when. So no grade is entered. "
         "<code>who.csv</code>, in this folder or where you gave it, has a line for each: write "
         "the student, or the time under <code>handed in</code>, and give the file as "
         "<code>WHO=</code>.",
         tally_why_undecided},
        {"passed-over", "Passed over",
         "Files of which no name says whose they are. If one is a student's, put it into a folder "
         "with the student's name. A list of a course system's name among them may be a "
         "student's, so it decides nothing.",
         NULL},
        {"not-graded", "Not graded",
         "The grader itself could not work here. That is no zero: run the same command again, it "
         "takes up only these.",
         why_not_graded},
    };
    json_t *lists = json_array();
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        const int has_files = all[i].why == NULL;
        json_t *members = has_files ? passed_over_files(&gradebook->roster)
                                    : listed_rows(gradebook, worksheet, all[i].why);
        json_t *list =
            json_pack("{s:s, s:s, s:s, s:b, s:O}", "id", all[i].id, "title", all[i].title, "what",
                      all[i].what, "has_files", has_files, has_files ? "files" : "listed", members);
        if (json_array_size(members) > 0) {
            json_array_append(lists, list);
        }
        json_decref(members), json_decref(list);
    }
    return lists;
}

// ---- The table -------------------------------------------------------------------------------

static void old_score_add(json_t *json, const Row *row)
{
    const int change = row->score - row->old_score;
    char text[16] = "";
    if (change != 0) {
        snprintf(text, sizeof text, "%+d", change);
    }
    if (row->has_old_score) {
        json_object_set_new(json, "old_score", json_integer(row->old_score));
        json_object_set_new(json, "change", json_string(text));
        json_object_set_new(json, "level", json_string(change < 0 ? "short" : "gain"));
    }
}

static json_t *row_of(const Gradebook *gradebook, const Row *row)
{
    json_t *json = class_row(row);
    json_t *points = json_array();
    for (int i = 0; i < gradebook->n_tasks; i++) {
        const Column *task = &gradebook->tasks[i];
        json_array_append_new(points,
                              json_pack("{s:s, s:i, s:b}", "id", task->id, "n", row->points[i],
                                        "is_short", row->points[i] < task->max_points));
    }
    json_object_update_new(
        json,
        json_pack("{s:s*, s:b, s:b, s:b, s:b, s:i, s:i, s:o, s:o}", "slug",
                  row->number > 0 ? NULL : row->entrant->slug, "is_outdated",
                  row->status == ROW_OUTDATED, "is_corrected", corrections_has(gradebook, row),
                  "is_late", lateness_is_late(lateness_of(gradebook, row)), "is_open",
                  row->time_unknown != NULL, "score", row->score, "max_score", gradebook->max_score,
                  "bar", template_bar(row->score, gradebook->max_score), "points", points));
    old_score_add(json, row);
    if (row->fault != NULL) {
        json_object_set_new(json, "fault", template_line(row->fault));
        json_object_set_new(json, "message", template_line(row->fault_message));
    }
    return json;
}

static json_t *table_of(const Gradebook *gradebook)
{
    json_t *rows = json_array();
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (row_is_graded(&gradebook->rows[i])) {
            json_array_append_new(rows, row_of(gradebook, &gradebook->rows[i]));
        }
    }
    return json_pack("{s:b, s:o}", "has_old", gradebook->has_old_scores, "graded", rows);
}

// ---- The page --------------------------------------------------------------------------------

static json_t *page_of(const Gradebook *gradebook, const Failures *failures,
                       const LookAlikes *look_alikes, const Leaderboard *leaderboard,
                       const Worksheet *worksheet)
{
    const Tally tally = tally_count(gradebook, worksheet, look_alikes->n_groups);
    json_t *page = json_pack(
        "{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "lab", template_line(gradebook->lab),
        "title", template_line(gradebook->title), "facts", facts_of(gradebook), "bars",
        class_bars(gradebook), "failures", class_failures(gradebook, failures), "tasks",
        class_tasks(gradebook), "checks", class_checks(gradebook), "leaderboard",
        class_leaderboard(gradebook, leaderboard), "pictures", class_pictures(gradebook));
    if (gradebook->n_graded > 0) {
        json_object_set_new(page, "table", table_of(gradebook));
    }
    // The page without names is not for those who have something to decide.
    if (!gradebook->has_no_names) {
        json_object_update_new(page, json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "tally",
                                               template_markup(tally_markup, &tally), "lists",
                                               lists_of(gradebook, worksheet), "look_alikes",
                                               class_look_alikes(look_alikes), "corrections",
                                               class_corrections(gradebook), "late",
                                               class_late(gradebook), "compared",
                                               class_compared(gradebook)));
    }
    return page;
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
        char title[256];
        snprintf(title, sizeof title, "%s: the class",
                 gradebook->lab != NULL ? gradebook->lab : "");
        html_album_begin(output.file, title);
        const int failed =
            template_write(output.file, class_html,
                           page_of(gradebook, &failures, &look_alikes, &leaderboard, worksheet));
        html_page_end(output.file);
        result = template_commit(&output, failed);
    }
    failures_free(&failures);
    look_alikes_free(&look_alikes);
    leaderboard_free(&leaderboard);
    return result;
}

// ---- Without names ---------------------------------------------------------------------------

static int texts_compare(const char *a, const char *b)
{
    return a != NULL && b != NULL ? strcmp(a, b) : (b == NULL) - (a == NULL);
}

// The best first. Of equal scores the order is that of what the page shows of them, and not that of
// their names.
static int shown_compare(const void *left, const void *right)
{
    const Row *a = left, *b = right;
    const int orders[] = {
        row_is_graded(b) - row_is_graded(a),
        b->score - a->score,
        memcmp(b->passed, a->passed, sizeof a->passed),
        memcmp(b->points, a->points, sizeof a->points),
        b->old_score - a->old_score,
        (int)a->status - (int)b->status,
        (a->leaderboard < b->leaderboard) - (a->leaderboard > b->leaderboard),
        texts_compare(a->fault, b->fault),
        texts_compare(a->fault_message, b->fault_message),
    };
    size_t i = 0;
    while (i + 1 < sizeof orders / sizeof *orders && orders[i] == 0) {
        i++;
    }
    return orders[i];
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
