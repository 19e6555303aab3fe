// class-figures.json: which checks a class fails, and why, without anything about a person (see
// term.h).
//
// It has texts of the labs and of our judge, and counts: no name, number, path, report or message
// of a submission. So every text is taken from a place that no student writes to.
#include "term.h"

#include "complain.h"
#include "output_file.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

// Does the list have this text?
static int list_has(const json_t *list, const char *text)
{
    size_t i;
    json_t *member;
    json_array_foreach(list, i, member)
    {
        if (json_is_string(member) && strcmp(json_string_value(member), text) == 0) {
            return 1;
        }
    }
    return 0;
}

// Was it graded, and does it count? An earlier attempt is no other student's.
static int is_counted(const json_t *row)
{
    return json_is_true(json_object_get(row, "counts")) &&
           json_is_object(json_object_get(row, "points"));
}

// The most frequent first; of equals in the order of the alphabet.
static int causes_compare(const void *left, const void *right)
{
    const json_t *a = *(json_t *const *)left, *b = *(json_t *const *)right;
    const json_int_t more = json_integer_value(json_object_get(b, "submissions")) -
                            json_integer_value(json_object_get(a, "submissions"));
    return more != 0 ? (more > 0) - (more < 0)
                     : strcmp(json_string_value(json_object_get(a, "cause")),
                              json_string_value(json_object_get(b, "cause")));
}

// From {cause: count} to a list.
static json_t *causes_sorted(const json_t *counts)
{
    const size_t n = json_object_size(counts);
    json_t **causes = calloc(n + 1, sizeof *causes);
    json_t *list = json_array();
    const char *cause;
    json_t *count;
    size_t i = 0;
    json_object_foreach((json_t *)counts, cause, count)
    {
        if (causes != NULL) {
            causes[i++] = json_pack("{s:s, s:O}", "cause", cause, "submissions", count);
        }
    }
    if (causes != NULL) {
        qsort(causes, i, sizeof *causes, causes_compare);
    }
    for (size_t c = 0; c < i; c++) {
        json_array_append_new(list, causes[c]);
    }
    free(causes);
    return list;
}

static json_t *check_figures(const json_t *rows, const json_t *check)
{
    const char *id = json_string_value(json_object_get(check, "id"));
    json_int_t n_failed = 0, n_not_run = 0;
    json_t *counts = json_object();
    size_t i;
    json_t *row;
    json_array_foreach(rows, i, row)
    {
        if (!is_counted(row) || !list_has(json_object_get(row, "not_passed"), id)) {
            continue;
        }
        const int is_not_run = list_has(json_object_get(row, "not_run"), id);
        n_not_run += is_not_run;
        n_failed += !is_not_run;
        const char *cause = json_string_value(json_object_get(json_object_get(row, "causes"), id));
        if (cause != NULL) {
            const json_int_t before = json_integer_value(json_object_get(counts, cause));
            json_object_set_new(counts, cause, json_integer(before + 1));
        }
    }
    json_t *figures =
        json_pack("{s:O, s:O, s:O, s:I, s:I, s:o}", "check", json_object_get(check, "id"), "title",
                  json_object_get(check, "title"), "task", json_object_get(check, "task"), "failed",
                  n_failed, "not_run", n_not_run, "causes", causes_sorted(counts));
    json_decref(counts);
    return figures;
}

// The points that all counted rows have together in a task.
static json_int_t task_points(const json_t *rows, const char *task)
{
    json_int_t sum = 0;
    size_t i;
    json_t *row;
    json_array_foreach(rows, i, row)
    {
        if (is_counted(row)) {
            sum += json_integer_value(json_object_get(json_object_get(row, "points"), task));
        }
    }
    return sum;
}

static json_t *tasks_figures(const TermLab *lab, const json_t *rows, json_int_t n_submissions)
{
    json_t *tasks = json_array();
    size_t i;
    json_t *task;
    json_array_foreach(json_object_get(lab->json, "tasks"), i, task)
    {
        const char *id = json_string_value(json_object_get(task, "id"));
        const double sum = id != NULL ? (double)task_points(rows, id) : 0;
        const double mean = n_submissions > 0 ? sum / (double)n_submissions : 0;
        json_array_append_new(tasks,
                              json_pack("{s:O, s:O, s:O, s:f}", "task", json_object_get(task, "id"),
                                        "title", json_object_get(task, "title"), "max_points",
                                        json_object_get(task, "max_points"), "mean", mean));
    }
    return tasks;
}

static json_t *lab_figures(const TermLab *lab)
{
    const json_t *rows = json_object_get(lab->json, "students");
    json_int_t n_submissions = 0;
    json_t *checks = json_array();
    size_t i;
    json_t *row, *check;
    json_array_foreach(rows, i, row)
    {
        n_submissions += is_counted(row);
    }
    json_array_foreach(json_object_get(lab->json, "checks"), i, check)
    {
        json_array_append_new(checks, check_figures(rows, check));
    }
    return json_pack("{s:s, s:O, s:I, s:o, s:o}", "lab", lab->lab, "title",
                     json_object_get(lab->json, "title"), "submissions", n_submissions, "tasks",
                     tasks_figures(lab, rows, n_submissions), "checks", checks);
}

// ---- The short table -------------------------------------------------------------------------

// Of each lab these are printed: the checks that fail most often.
enum { MOST_CHECKS = 5 };

static int checks_compare(const void *left, const void *right)
{
    const json_t *a = *(json_t *const *)left, *b = *(json_t *const *)right;
    const json_int_t more = json_integer_value(json_object_get(b, "failed")) -
                            json_integer_value(json_object_get(a, "failed"));
    return more != 0 ? (more > 0) - (more < 0)
                     : strcmp(json_string_value(json_object_get(a, "check")),
                              json_string_value(json_object_get(b, "check")));
}

static void lab_print(const json_t *lab)
{
    const json_t *checks = json_object_get(lab, "checks");
    const size_t n = json_array_size(checks);
    json_t **sorted = calloc(n + 1, sizeof *sorted);
    printf("%s, %" JSON_INTEGER_FORMAT " submissions\n",
           json_string_value(json_object_get(lab, "lab")),
           json_integer_value(json_object_get(lab, "submissions")));
    for (size_t i = 0; sorted != NULL && i < n; i++) {
        sorted[i] = json_array_get(checks, i);
    }
    if (sorted != NULL) {
        qsort(sorted, n, sizeof *sorted, checks_compare);
    }
    for (size_t i = 0; sorted != NULL && i < n && i < MOST_CHECKS; i++) {
        const json_int_t n_failed = json_integer_value(json_object_get(sorted[i], "failed"));
        const json_t *cause = json_array_get(json_object_get(sorted[i], "causes"), 0);
        if (n_failed == 0) {
            break;
        }
        printf("  %" JSON_INTEGER_FORMAT " failed %s (task %s)", n_failed,
               json_string_value(json_object_get(sorted[i], "check")),
               json_string_value(json_object_get(sorted[i], "task")));
        if (cause != NULL) {
            printf(", %" JSON_INTEGER_FORMAT " of them: %s",
                   json_integer_value(json_object_get(cause, "submissions")),
                   json_string_value(json_object_get(cause, "cause")));
        }
        printf("\n");
    }
    free(sorted);
}

// ---- The file --------------------------------------------------------------------------------

// Are the lists there that figures are made of? Returns 0, or -1 after one message.
static int has_checks(const TermLab *lab)
{
    static const char *const texts[] = {"id", "title", "task"};
    const json_t *checks = json_object_get(lab->json, "checks");
    int is_good = json_is_array(checks);
    size_t i;
    json_t *check;
    json_array_foreach(checks, i, check)
    {
        for (int t = 0; t < 3; t++) {
            is_good = is_good && json_is_string(json_object_get(check, texts[t]));
        }
    }
    if (!is_good) {
        complain("term: %s/gradebook.json: of an older version: run make grade-class for it again",
                 lab->folder);
    }
    return is_good ? 0 : -1;
}

int term_figures(const Term *term, const char *path)
{
    json_t *labs = json_array();
    OutputFile output;
    int result = 0;
    for (int i = 0; result == 0 && i < term->n_labs; i++) {
        result = has_checks(&term->labs[i]);
        if (result == 0) {
            json_array_append_new(labs, lab_figures(&term->labs[i]));
        }
    }
    json_t *whole = json_pack("{s:o}", "labs", labs);
    if (result == 0 && json_array_size(labs) != (size_t)term->n_labs) {
        complain("term: out of memory");
        result = -1;
    }
    if (result == 0 && (result = output_file_open(&output, path)) == 0) {
        json_dumpf(whole, output.file, JSON_INDENT(2) | JSON_REAL_PRECISION(6));
        fputc('\n', output.file);
        result = output_file_commit(&output);
    }
    for (size_t i = 0; result == 0 && i < json_array_size(labs); i++) {
        lab_print(json_array_get(labs, i));
    }
    json_decref(whole);
    return result;
}
