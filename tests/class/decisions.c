// Reading and offering decisions (see decisions.h).
#include "decisions.h"

#include "called.h"
#include "complain.h"
#include "csv_cell.h"
#include "output_file.h"
#include "participant_fit.h"
#include "path.h"
#include "tally.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ENTRY, STUDENT, COUNTS, NAME, REASON, N_COLUMNS };
static const char *const titles[N_COLUMNS] = {"entry", "student", "counts", "name", "reason"};
static const char file_kind[] = "a list of entries and students";

const char *decision_word(DecisionKind kind)
{
    static const char *const words[] = {
        [DECISION_YES] = "yes", [DECISION_NO] = "no", [DECISION_IGNORE] = "ignore"};
    return words[kind];
}

// ---- Reading -----------------------------------------------------------------------------------

static int row_find(const Decisions *decisions, const Gradebook *gradebook, const char *entry,
                    Decision *decision)
{
    const Called called = called_entry(gradebook, entry);
    const char *path = decisions->path;
    if (called.n == 0) {
        return sheet_fault(path, decision->line,
                           "found the entry \"%.200s\", expected an \"entry\" or \"id\" of "
                           "gradebook.json",
                           entry);
    }
    const Row *row = &gradebook->rows[called.first];
    if (called.n > 1) {
        return sheet_fault(
            path, decision->line,
            "\"%.200s\" is the name of %d entries, among them %.100s and %.100s; expected "
            "one of these slugs",
            entry, called.n, row->entrant->slug, gradebook->rows[called.last].entrant->slug);
    }
    const Row *counts = row_that_counts(gradebook, row);
    if (counts != row) {
        return sheet_fault(path, decision->line,
                           "\"%.200s\" is another attempt of a student of whom \"%.200s\" counts",
                           entry, counts->entrant->entry);
    }
    decision->row = called.first;
    return 0;
}

static int participant_find(const Decisions *decisions, const Worksheet *worksheet,
                            Decision *decision)
{
    const Called called = called_participant(worksheet, decision->student);
    if (called.n == 1 && !is_no_person(worksheet, &worksheet->participants[called.first])) {
        decision->participant = called.first;
        return 0;
    }
    if (called.n > 1) {
        return sheet_fault(
            decisions->path, decision->line,
            "\"%.200s\" fits %d lines of the list of participants, among them %d and %d; "
            "expected an address or a number",
            decision->student, called.n, called.first + 1, called.last + 1);
    }
    return sheet_fault(
        decisions->path, decision->line,
        "found the student \"%.200s\", expected a name, number or address of the list of "
        "participants",
        decision->student);
}

static int kind_read(const Decisions *decisions, const char *counts, Decision *decision)
{
    for (int kind = DECISION_YES; kind <= DECISION_IGNORE; kind++) {
        if (strcmp(counts, decision_word((DecisionKind)kind)) == 0) {
            decision->kind = (DecisionKind)kind;
            counts = "";
        }
    }
    if (counts[0] != '\0') {
        return sheet_fault(decisions->path, decision->line,
                           "found \"%.200s\" in the column \"counts\", expected yes, no or ignore",
                           counts);
    }
    const int has_student = decision->student[0] != '\0';
    if (has_student != (decision->kind != DECISION_IGNORE)) {
        return sheet_fault(decisions->path, decision->line, "found %s beside \"%s\", expected %s",
                           has_student ? "a student" : "no student", decision_word(decision->kind),
                           has_student ? "none" : "one");
    }
    return 0;
}

// A team's entry may be several participants', each once. Nothing else stands twice.
static int contradiction_find(const Decisions *decisions, const Decision *decision)
{
    for (int i = 0; i < decisions->n; i++) {
        const Decision *other = &decisions->all[i];
        if (other->row == decision->row &&
            (other->kind != DECISION_YES || decision->kind != DECISION_YES ||
             other->participant == decision->participant)) {
            return sheet_fault(decisions->path, decision->line,
                               "line %d decides about the same entry already", other->line);
        }
        if (other->kind == DECISION_YES && decision->kind == DECISION_YES &&
            other->participant == decision->participant) {
            return sheet_fault(
                decisions->path, decision->line,
                "line %d gives the same student another entry: one of them needs \"no\"",
                other->line);
        }
    }
    return 0;
}

static int line_read(Decisions *decisions, const Gradebook *gradebook, const Worksheet *worksheet,
                     int i, const int *columns)
{
    const SheetLine *line = &decisions->sheet.lines[i];
    const char *counts = columns[COUNTS] >= 0 ? line->cells[columns[COUNTS]] : "";
    Decision decision = {.line = i + 1, .student = line->cells[columns[STUDENT]]};
    if (decision.student[0] == '\0' && counts[0] == '\0') {
        return 0;
    }
    if (row_find(decisions, gradebook, line->cells[columns[ENTRY]], &decision) != 0 ||
        kind_read(decisions, counts, &decision) != 0 ||
        (decision.kind != DECISION_IGNORE &&
         participant_find(decisions, worksheet, &decision) != 0) ||
        contradiction_find(decisions, &decision) != 0) {
        return -1;
    }
    decisions->all[decisions->n++] = decision;
    return 0;
}

int decisions_load(const char *path, const Gradebook *gradebook, const Worksheet *worksheet,
                   Decisions *decisions)
{
    int columns[N_COLUMNS];
    *decisions = (Decisions){.path = path};
    Sheet *sheet = &decisions->sheet;
    int result = sheet_load(path, file_kind, sheet);
    if (result == 0) {
        result = sheet_columns_find(sheet, path, titles, N_COLUMNS, STUDENT + 1, columns);
    }
    if (result == 0) {
        decisions->all = calloc((size_t)sheet->n_lines, sizeof *decisions->all);
        result = decisions->all != NULL ? 0 : sheet_fault(path, 1, "out of memory");
    }
    for (int i = 1; result == 0 && i < sheet->n_lines; i++) {
        result = line_read(decisions, gradebook, worksheet, i, columns);
    }
    if (result != 0) {
        decisions_free(decisions);
    }
    return result;
}

void decisions_free(Decisions *decisions)
{
    free(decisions->all);
    sheet_free(&decisions->sheet);
    *decisions = (Decisions){0};
}

// ---- Offering ----------------------------------------------------------------------------------

static int is_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

// Is the file there, with somebody's decisions in it, or something else that we did not write?
static int has_decisions(const char *path)
{
    Sheet sheet;
    int columns[N_COLUMNS], has = 0;
    if (access(path, F_OK) != 0) {
        return 0;
    }
    if (sheet_load(path, file_kind, &sheet) != 0) {
        return 1;
    }
    has = sheet_columns_find(&sheet, path, titles, N_COLUMNS, N_COLUMNS, columns) != 0;
    for (int i = 1; !has && i < sheet.n_lines; i++) {
        has = sheet.lines[i].cells[columns[STUDENT]][0] != '\0' ||
              sheet.lines[i].cells[columns[COUNTS]][0] != '\0';
    }
    sheet_free(&sheet);
    return has;
}

static void line_write(FILE *file, const Row *row, const char *student, const char *counts,
                       const char *reason)
{
    const char *const cells[N_COLUMNS] = {row->entrant->slug, student, counts, row->entrant->entry,
                                          reason};
    for (int i = 0; i < N_COLUMNS; i++) {
        fputs(i > 0 ? "," : "", file);
        csv_cell_write(file, cells[i]);
    }
    fputc('\n', file);
}

static int is_decided(const Decisions *decisions, int row)
{
    int i = 0;
    while (i < decisions->n && decisions->all[i].row != row) {
        i++;
    }
    return i < decisions->n;
}

static void lines_write(FILE *file, const Gradebook *gradebook, const Worksheet *worksheet)
{
    const Decisions *decisions = worksheet->decisions;
    for (int i = 0; i < N_COLUMNS; i++) {
        fprintf(file, "%s%s", i > 0 ? "," : "", titles[i]);
    }
    fputc('\n', file);
    for (int i = 0; decisions != NULL && i < decisions->n; i++) {
        const Decision *decision = &decisions->all[i];
        const char *why_not = worksheet->entered[decision->row].why_not;
        line_write(file, &gradebook->rows[decision->row], decision->student,
                   decision_word(decision->kind), why_not != NULL ? why_not : "decided");
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (tally_is_undecided(gradebook, worksheet, row) &&
            (decisions == NULL || !is_decided(decisions, i))) {
            line_write(file, row, "", "", worksheet->entered[i].why_not);
        }
    }
}

int decisions_offer(const Gradebook *gradebook, const Worksheet *worksheet, int *n_open)
{
    const Decisions *decisions = worksheet->decisions;
    char path[PATH_MAX];
    path_make(path, "%s/who.csv", gradebook->folder);
    *n_open = 0;
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        n += tally_is_undecided(gradebook, worksheet, &gradebook->rows[i]);
    }
    const int is_given = decisions != NULL && is_same_file(path, decisions->path);
    if (!is_given && has_decisions(path)) {
        complain("gradebook: %s: has decisions of yours, so it is not written anew; give it as "
                 "WHO=, or remove it",
                 path);
        return 0;
    }
    if (n == 0 && !is_given) {
        unlink(path);
        return 0;
    }
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    lines_write(output.file, gradebook, worksheet);
    *n_open = n;
    return output_file_commit(&output);
}
