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

enum { ENTRY, STUDENT, COUNTS, HANDED_IN, NAME, REASON, N_COLUMNS };
static const char *const titles[N_COLUMNS] = {"entry",     "student", "counts",
                                              "handed in", "name",    "reason"};
static const char file_kind[] = "a list of entries, their students and times";

const char *decision_word(DecisionKind kind)
{
    static const char *const words[] = {[DECISION_YES] = "yes",
                                        [DECISION_NO] = "no",
                                        [DECISION_IGNORE] = "ignore",
                                        [DECISION_TIME] = ""};
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
    decision->kind = DECISION_YES;
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

// May two lines of one entry stand? A team's is several participants', each once. Nothing else
// stands twice, and there is one time.
static int is_compatible(const Decision *a, const Decision *b)
{
    const int is_one_time = a->handed_in[0] == '\0' || b->handed_in[0] == '\0' ||
                            strcmp(a->handed_in, b->handed_in) == 0;
    const int is_one_owner =
        a->kind == DECISION_TIME || b->kind == DECISION_TIME ||
        (a->kind == DECISION_YES && b->kind == DECISION_YES && a->participant != b->participant);
    return is_one_time && is_one_owner;
}

static int contradiction_find(const Decisions *decisions, const Decision *decision)
{
    for (int i = 0; i < decisions->n; i++) {
        const Decision *other = &decisions->all[i];
        if (other->row == decision->row && !is_compatible(other, decision)) {
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

static const char *cell_of(const SheetLine *line, int column)
{
    return column >= 0 ? line->cells[column] : "";
}

static int line_read(Decisions *decisions, const Gradebook *gradebook, const Worksheet *worksheet,
                     int i, const int *columns)
{
    const SheetLine *line = &decisions->sheet.lines[i];
    Decision decision = {.line = i + 1,
                         .kind = DECISION_TIME,
                         .student = cell_of(line, columns[STUDENT]),
                         .handed_in = cell_of(line, columns[HANDED_IN])};
    const char *counts = cell_of(line, columns[COUNTS]);
    const int says_whose = decision.student[0] != '\0' || counts[0] != '\0';
    if (!says_whose && decision.handed_in[0] == '\0') {
        return 0;
    }
    if (says_whose && worksheet == NULL) {
        return sheet_fault(decisions->path, decision.line,
                           "found whose an entry is, and no list of participants beside it, "
                           "expected LIST=");
    }
    if (row_find(decisions, gradebook, cell_of(line, columns[ENTRY]), &decision) != 0 ||
        (says_whose && kind_read(decisions, counts, &decision) != 0) ||
        ((decision.kind == DECISION_YES || decision.kind == DECISION_NO) &&
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
        const int n_needed = worksheet != NULL ? STUDENT + 1 : ENTRY + 1;
        result = sheet_columns_find(sheet, path, titles, N_COLUMNS, n_needed, columns);
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
    has = sheet_columns_find(&sheet, path, titles, N_COLUMNS, STUDENT + 1, columns) != 0;
    for (int i = 1; !has && i < sheet.n_lines; i++) {
        has = cell_of(&sheet.lines[i], columns[STUDENT])[0] != '\0' ||
              cell_of(&sheet.lines[i], columns[COUNTS])[0] != '\0' ||
              cell_of(&sheet.lines[i], columns[HANDED_IN])[0] != '\0';
    }
    sheet_free(&sheet);
    return has;
}

static void line_write(FILE *file, const Row *row, const Decision *decision, const char *reason)
{
    const char *const cells[N_COLUMNS] = {
        row->entrant->slug,  decision->student,   decision_word(decision->kind),
        decision->handed_in, row->entrant->entry, reason};
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
    static const Decision open = {.kind = DECISION_TIME, .student = "", .handed_in = ""};
    const Decisions *decisions = gradebook->decisions;
    for (int i = 0; i < N_COLUMNS; i++) {
        fprintf(file, "%s%s", i > 0 ? "," : "", titles[i]);
    }
    fputc('\n', file);
    for (int i = 0; decisions != NULL && i < decisions->n; i++) {
        const Row *row = &gradebook->rows[decisions->all[i].row];
        const char *why = tally_why_undecided(gradebook, worksheet, row);
        line_write(file, row, &decisions->all[i], why != NULL ? why : "decided");
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const char *why = tally_why_undecided(gradebook, worksheet, row);
        if (why != NULL && (decisions == NULL || !is_decided(decisions, i))) {
            line_write(file, row, &open, why);
        }
    }
}

int decisions_offer(const Gradebook *gradebook, const Worksheet *worksheet, int *n_open)
{
    const Decisions *decisions = gradebook->decisions;
    char path[PATH_MAX];
    path_make(path, "%s/who.csv", gradebook->folder);
    *n_open = 0;
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        n += tally_why_undecided(gradebook, worksheet, &gradebook->rows[i]) != NULL;
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
