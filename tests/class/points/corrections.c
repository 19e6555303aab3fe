// Reading and applying corrections (see corrections.h). Read next: corrections_tell.c.
#include "corrections.h"

#include "called.h"
#include "clean_text.h"
#include "manifest.h"
#include "participant_fit.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { STUDENT, TASK, POINTS, COMMENT, UNTIL, N_COLUMNS };
static const char *const titles[N_COLUMNS] = {"student", "task", "points", "comment", "until"};

// ---- A line ------------------------------------------------------------------------------------

// "12", "+5" or "-5", and nothing else. A spreadsheet may have put an apostrophe before it.
static int points_read(const char *text, Correction *correction)
{
    text += text[0] == '\'';
    correction->is_relative = text[0] == '+' || text[0] == '-';
    const char *digits = text + correction->is_relative;
    const size_t length = strlen(digits);
    if (length == 0 || length > 4 || strspn(digits, "0123456789") != length) {
        return -1;
    }
    correction->points = atoi(text);
    correction->has_points = 1;
    return 0;
}

// "24.12.2026", as a German spreadsheet writes it, becomes "2026-12-24" in its place.
static void day_settle(char *text)
{
    if (strlen(text) == 10 && text[2] == '.' && text[5] == '.') {
        const char day[] = {text[6], text[7], text[8], text[9], '-', text[3],
                            text[4], '-',     text[0], text[1], '\0'};
        memcpy(text, day, sizeof day);
    }
}

static int is_day(const char *text)
{
    static const int days[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    int month, day, length = 0;
    if (strlen(text) != 10 || strspn(text, "0123456789-") != 10 ||
        sscanf(text, "%*4[0-9]-%2d-%2d%n", &month, &day, &length) != 2 || length != 10) {
        return 0;
    }
    return month >= 1 && month <= 12 && day >= 1 && day <= days[month - 1];
}

// The participants of this name who have handed in nothing that is entered.
static Called called_without(const Worksheet *worksheet, const char *name)
{
    Called called = {0};
    if (worksheet != NULL) {
        called = called_participant(worksheet, name);
    }
    if (called.n == 1 && (worksheet->participants[called.first].row != NULL ||
                          is_no_person(worksheet, &worksheet->participants[called.first]))) {
        called.n = 0;
    }
    return called;
}

static int student_find(const Corrections *corrections, const Gradebook *gradebook,
                        const char *name, Correction *correction)
{
    const Worksheet *worksheet = corrections->worksheet;
    const Called called = called_student(gradebook, worksheet, name);
    const Called without = called_without(worksheet, name);
    if (called.n > 1) {
        return sheet_fault(
            corrections->path, correction->line,
            "\"%.200s\" is the name of %d submissions, among them %.100s and %.100s; "
            "expected one of these slugs",
            name, called.n, gradebook->rows[called.first].entrant->slug,
            gradebook->rows[called.last].entrant->slug);
    }
    if (called.n + without.n > 1) {
        return sheet_fault(
            corrections->path, correction->line,
            "\"%.200s\" fits line %d of the list of participants, and %s; expected a slug "
            "or an e-mail address",
            name, without.first + 1,
            called.n > 0 ? "a submission that is not entered for it" : "another one");
    }
    if (called.n + without.n == 0) {
        return sheet_fault(
            corrections->path, correction->line,
            "found the student \"%.200s\", who is not in this class; expected a name, "
            "number, slug or e-mail address as in gradebook.json",
            name);
    }
    if (called.n == 1) {
        correction->row = &gradebook->rows[called.first];
    } else {
        correction->participant = &worksheet->participants[without.first];
    }
    return 0;
}

static int is_score(const Correction *correction)
{
    return correction->task != NULL && strcmp(correction->task, SCORE) == 0;
}

// Find the task or check of this id, or the score. Returns 0, or -1 where there is none, or when
// memory runs out.
static int task_find(const Manifest *manifest, const char *id, Correction *correction)
{
    int total = 0;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        int sum = 0;
        for (int c = 0; c < task->n_checks; c++) {
            sum += task->checks[c].points;
            if (strcmp(task->checks[c].id, id) == 0) {
                correction->task = strdup(task->id);
                correction->check = strdup(id);
                correction->max_points = task->checks[c].points;
                return correction->task != NULL && correction->check != NULL ? 0 : -1;
            }
        }
        if (strcmp(task->id, id) == 0) {
            correction->task = strdup(id);
            correction->max_points = sum;
            return correction->task != NULL ? 0 : -1;
        }
        total += sum;
    }
    if (strcmp(id, SCORE) != 0) {
        return -1;
    }
    correction->task = strdup(SCORE);
    correction->max_points = total;
    return correction->task != NULL ? 0 : -1;
}

static const char *cell_of(const SheetLine *line, int column)
{
    return column >= 0 ? line->cells[column] : "";
}

// The task and its points, where any are given.
static int change_read(const Corrections *corrections, const Manifest *manifest, const char *id,
                       const char *points, Correction *correction)
{
    const int line = correction->line;
    if (id[0] == '\0' && points[0] == '\0') {
        return 0;
    }
    if (task_find(manifest, id, correction) != 0) {
        return sheet_fault(corrections->path, line,
                           "found the task \"%.200s\", expected a task or check of %s, or score",
                           id, manifest->lab);
    }
    if (points[0] == '\0') {
        return 0;
    }
    if (points_read(points, correction) != 0) {
        return sheet_fault(corrections->path, line,
                           "found \"%.200s\" points, expected a whole number such as 12, +5 or -5",
                           points);
    }
    if (correction->row == NULL) {
        return sheet_fault(corrections->path, line,
                           "found points of a student who handed in nothing");
    }
    if (abs(correction->points) > correction->max_points) {
        return sheet_fault(corrections->path, line, "found %s points, but %s has 0 to %d", points,
                           id, correction->max_points);
    }
    return 0;
}

// Does an earlier line change the same points? A task's are those of its checks, and the score is
// everybody's.
static int is_taken(const Corrections *corrections, const Correction *correction)
{
    for (int i = 0; correction->has_points && &corrections->all[i] != correction; i++) {
        const Correction *other = &corrections->all[i];
        if (other->has_points && other->row == correction->row &&
            (is_score(other) || is_score(correction) ||
             strcmp(other->task, correction->task) == 0) &&
            (other->check == NULL || correction->check == NULL ||
             strcmp(other->check, correction->check) == 0)) {
            return other->line;
        }
    }
    return 0;
}

static int line_read(Corrections *corrections, const Manifest *manifest, const Gradebook *gradebook,
                     const SheetLine *line, const int *columns)
{
    // What it owns is freed with the others, also when it is refused.
    Correction *correction = &corrections->all[corrections->n];
    if (columns[UNTIL] >= 0) {
        day_settle(line->cells[columns[UNTIL]]);
    }
    *correction =
        (Correction){.line = (int)(line - corrections->sheet.lines) + 1,
                     .comment = text_clean(cell_of(line, columns[COMMENT]), TEXT_IN_A_LINE),
                     .until = cell_of(line, columns[UNTIL])};
    corrections->n++;
    int result =
        student_find(corrections, gradebook, line->cells[columns[STUDENT]], correction) != 0 ||
        change_read(corrections, manifest, line->cells[columns[TASK]], line->cells[columns[POINTS]],
                    correction) != 0;
    if (result == 0 && correction->until[0] != '\0' && !is_day(correction->until)) {
        result = sheet_fault(corrections->path, correction->line,
                             "found \"%.200s\" in the column \"until\", expected a day such as "
                             "2026-12-24",
                             correction->until);
    }
    if (result == 0 && !correction->has_points && correction->comment[0] == '\0' &&
        correction->until[0] == '\0') {
        result = sheet_fault(corrections->path, correction->line,
                             "found a student only, expected points, a comment or a day");
    }
    const int taken = result == 0 ? is_taken(corrections, correction) : 0;
    if (taken > 0) {
        result = sheet_fault(corrections->path, correction->line,
                             "line %d changes the same points already", taken);
    }
    return result != 0 ? -1 : 0;
}

int corrections_load(const char *path, const char *lab, const Gradebook *gradebook,
                     const Worksheet *worksheet, Corrections *corrections)
{
    Manifest manifest;
    int columns[N_COLUMNS];
    *corrections = (Corrections){.path = path, .worksheet = worksheet};
    Sheet *sheet = &corrections->sheet;
    if (gradebook_manifest(gradebook, lab, &manifest) != 0) {
        return -1;
    }
    int result = sheet_load(path, "a list of corrections", sheet);
    if (result == 0) {
        result = sheet_columns_find(sheet, path, titles, N_COLUMNS, POINTS + 1, columns);
    }
    if (result == 0) {
        corrections->all = calloc((size_t)sheet->n_lines, sizeof *corrections->all);
        result = corrections->all != NULL ? 0 : sheet_fault(corrections->path, 1, "out of memory");
    }
    for (int i = 1; result == 0 && i < sheet->n_lines; i++) {
        if (!sheet_line_is_empty(sheet, &sheet->lines[i])) {
            result = line_read(corrections, &manifest, gradebook, &sheet->lines[i], columns);
        }
    }
    manifest_free(&manifest);
    if (result != 0) {
        corrections_free(corrections);
    }
    return result;
}

void corrections_free(Corrections *corrections)
{
    for (int i = 0; i < corrections->n; i++) {
        Correction *correction = &corrections->all[i];
        free(correction->task), free(correction->check), free(correction->comment);
    }
    free(corrections->all);
    sheet_free(&corrections->sheet);
    *corrections = (Corrections){0};
}

// ---- Applying ----------------------------------------------------------------------------------

static int column_find(const Column *columns, int n_columns, const char *id)
{
    int i = 0;
    while (i < n_columns && strcmp(columns[i].id, id) != 0) {
        i++;
    }
    return i < n_columns ? i : -1;
}

// What points become that were `before`. Returns 0, or -1 after one message.
static int change_take(const Corrections *corrections, int before, const char *id,
                       Correction *correction)
{
    correction->before = before;
    correction->after = correction->points + (correction->is_relative ? correction->before : 0);
    if (correction->after < 0 || correction->after > correction->max_points) {
        return sheet_fault(corrections->path, correction->line,
                           "%+d to the %d points of %s is not in 0 to %d", correction->points,
                           correction->before, id, correction->max_points);
    }
    correction->is_applied = 1;
    return 0;
}

// What a row had and gets. Returns 0, or -1 after one message.
static int change_find(const Corrections *corrections, const Gradebook *gradebook,
                       Correction *correction)
{
    const Row *row = correction->row;
    const char *id = correction->check != NULL ? correction->check : correction->task;
    if (is_score(correction)) {
        return change_take(corrections, row->score, id, correction);
    }
    const int column = correction->check != NULL
                           ? column_find(gradebook->checks, gradebook->n_checks, id)
                           : column_find(gradebook->tasks, gradebook->n_tasks, id);
    if (column < 0) {
        return sheet_fault(corrections->path, correction->line,
                           "%s is not in the results of this class", id);
    }
    const int before = correction->check != NULL ? row->check_points[column] : row->points[column];
    return change_take(corrections, before, id, correction);
}

// Where all points are given the check costs none any more, though it failed.
static void made_up_mark(const Gradebook *gradebook, const Correction *correction, Row *row)
{
    for (int i = 0; i < gradebook->n_checks; i++) {
        const Column *check = &gradebook->checks[i];
        row->is_made_up[i] |=
            correction->after == correction->max_points &&
            (is_score(correction) ||
             (strcmp(correction->task, check->task) == 0 &&
              (correction->check == NULL || strcmp(correction->check, check->id) == 0)));
    }
}

int corrections_apply(Corrections *corrections, Gradebook *gradebook)
{
    for (int i = 0; i < corrections->n; i++) {
        Correction *correction = &corrections->all[i];
        if (correction->has_points && row_is_graded(correction->row) &&
            change_find(corrections, gradebook, correction) != 0) {
            return -1;
        }
    }
    for (int i = 0; i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (correction->is_applied) {
            Row *row = &gradebook->rows[correction->row - gradebook->rows];
            const int change = correction->after - correction->before;
            if (!is_score(correction)) {
                row->points[column_find(gradebook->tasks, gradebook->n_tasks, correction->task)] +=
                    change;
            }
            row->score += change;
            made_up_mark(gradebook, correction, row);
        }
    }
    gradebook->corrections = corrections;
    for (int i = 0; i < gradebook->n_rows; i++) {
        row_fault_find(gradebook, &gradebook->rows[i]);
    }
    return 0;
}
