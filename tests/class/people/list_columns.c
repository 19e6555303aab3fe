// Reading the heads of lists (see list_columns.h).
//
//   Canvas        Student,ID,SIS User ID,SIS Login ID,Section,Lab 3 (4711),...,Final Score
//   Blackboard    Last Name,First Name,Username,...,Lab 3 [Total Pts: 100 Score] |12345,...
//   Brightspace   OrgDefinedId,Username,...,Lab 3 Points Grade <Numeric MaxPoints:100>,...
//   Moodle        Identifier,Full name,...,Grade,Maximum Grade,...
//
// What a system adds to a title does not depend on its language; Moodle's titles do.
#include "list_columns.h"

#include "sheet.h"
#include "worksheet.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Titles as Moodle writes them in English and in German.
static const char *const grade_titles[] = {"Grade", "Bewertung", NULL};
static const char *const maximum_titles[] = {"Maximum Grade", "Maximum grade", "Bestwertung", NULL};
static const char *const moodle_titles[] = {"Identifier", "ID", NULL};
// What Canvas needs to know a student again. It writes these titles in every language.
static const char *const canvas_titles[] = {
    "Student",      "LastName",       "FirstName",    "ID",      "SIS User ID",
    "SIS Login ID", "Integration ID", "Root Account", "Section", NULL};
static const char *const canvas_own_titles[] = {"SIS User ID", "SIS Login ID", NULL};
static const char *const brightspace_titles[] = {"End-of-Line Indicator", "OrgDefinedId", NULL};

const char *list_upload_words(ListSystem system)
{
    static const char *const words[N_LIST_SYSTEMS] = {
        [LIST_MOODLE] = "in the assignment choose Upload grading worksheet",
        [LIST_CANVAS] = "in Canvas choose Grades, Import",
        [LIST_BLACKBOARD] = "in the grade book choose Upload (Work Offline, Upload)",
        [LIST_BRIGHTSPACE] = "in Grades choose Enter Grades, Import",
    };
    return words[system];
}

static const char *title_of(const Worksheet *worksheet, int column)
{
    return worksheet->participants[0].cells[column];
}

// ---- Titles -----------------------------------------------------------------------------------

// How long a title is without " (4711)", Canvas' number of the assignment; 0: there is none.
static size_t canvas_stem(const char *title)
{
    const char *open = strrchr(title, '(');
    const size_t n_digits = open != NULL ? strspn(open + 1, "0123456789") : 0;
    const int is_tag = n_digits > 0 && strcmp(open + 1 + n_digits, ")") == 0;
    return is_tag && open > title + 1 && open[-1] == ' ' ? (size_t)(open - 1 - title) : 0;
}

// Without " [Total Pts: 100 Score] |12345".
static size_t blackboard_stem(const char *title)
{
    const char *bar = strrchr(title, '|');
    const int is_tag = bar != NULL && isdigit((unsigned char)bar[1]) &&
                       bar[1 + strspn(bar + 1, "0123456789")] == '\0';
    if (!is_tag) {
        return 0;
    }
    const char *bracket = bar;
    while (bracket > title && *bracket != '[') {
        bracket--;
    }
    const char *end = *bracket == '[' ? bracket : bar;
    while (end > title && end[-1] == ' ') {
        end--;
    }
    return (size_t)(end - title);
}

// Without " Points Grade <Numeric MaxPoints:100 Weight:10>".
static size_t brightspace_stem(const char *title)
{
    const char *tag = strstr(title, " Points Grade");
    return tag != NULL ? (size_t)(tag - title) : 0;
}

static size_t whole_title(const char *title)
{
    return strlen(title);
}

typedef size_t Stem(const char *title);

static Stem *stem_of(ListSystem system)
{
    static Stem *const stems[N_LIST_SYSTEMS] = {
        whole_title, whole_title, canvas_stem, blackboard_stem, brightspace_stem,
    };
    return stems[system];
}

// Has a title, so far as it is the instructor's, the number? *n counts all its numbers.
static int has_number(const char *title, size_t length, int number, int *n)
{
    int has = 0;
    *n = 0;
    for (size_t i = 0; i < length;) {
        const size_t n_digits = strspn(title + i, "0123456789");
        if (n_digits == 0) {
            i++;
            continue;
        }
        has = has || strtol(title + i, NULL, 10) == number;
        (*n)++;
        i += n_digits;
    }
    return has;
}

// ---- The system -------------------------------------------------------------------------------

static int has_tag(const Worksheet *worksheet, Stem *stem)
{
    int column = 0;
    while (column < worksheet->n_columns && stem(title_of(worksheet, column)) == 0) {
        column++;
    }
    return column < worksheet->n_columns;
}

static int is_canvas(const Worksheet *worksheet)
{
    static const char *const section[] = {"Section", NULL};
    return worksheet_column(worksheet, canvas_own_titles) >= 0 ||
           (worksheet->n_columns > 2 && strcmp(title_of(worksheet, 0), "Student") == 0 &&
            strcmp(title_of(worksheet, 1), "ID") == 0 && worksheet_column(worksheet, section) >= 0);
}

static ListSystem system_find(const Worksheet *worksheet)
{
    if (is_canvas(worksheet)) {
        return LIST_CANVAS;
    }
    if (has_tag(worksheet, blackboard_stem)) {
        return LIST_BLACKBOARD;
    }
    if (has_tag(worksheet, brightspace_stem) ||
        worksheet_column(worksheet, brightspace_titles) >= 0) {
        return LIST_BRIGHTSPACE;
    }
    return worksheet_column(worksheet, grade_titles) >= 0 &&
                   worksheet_column(worksheet, moodle_titles) >= 0
               ? LIST_MOODLE
               : LIST_OTHER;
}

// ---- The column -------------------------------------------------------------------------------

// The line of Canvas with the most points of each column, or NULL.
static const Participant *points_possible(const Worksheet *worksheet)
{
    for (int i = 1; i < worksheet->n_participants; i++) {
        if (strstr(worksheet->participants[i].cells[0], "Points Possible") != NULL) {
            return &worksheet->participants[i];
        }
    }
    return NULL;
}

// May grades stand in a column? Canvas says "(read only)", in its language, below its sums.
static int is_candidate(const Worksheet *worksheet, int column, const char *wanted)
{
    const char *title = title_of(worksheet, column);
    if (worksheet->system == LIST_OTHER || worksheet->system == LIST_MOODLE) {
        return worksheet_has_title(worksheet, column, grade_titles) ||
               (wanted != NULL && strcmp(title, wanted) == 0);
    }
    const Participant *points =
        worksheet->system == LIST_CANVAS ? points_possible(worksheet) : NULL;
    return stem_of(worksheet->system)(title) > 0 &&
           (points == NULL || points->cells[column][0] != '(');
}

typedef struct Candidates {
    int n;
    int columns[SHEET_MAX_COLUMNS];
} Candidates;

static Candidates candidates_find(const Worksheet *worksheet, const char *wanted)
{
    Candidates candidates = {0};
    for (int i = 0; i < worksheet->n_columns; i++) {
        if (is_candidate(worksheet, i, wanted)) {
            candidates.columns[candidates.n++] = i;
        }
    }
    return candidates;
}

// Those that are called so, or have the lab's number.
static Candidates candidates_choose(const Worksheet *worksheet, const Candidates *all,
                                    const char *wanted, int lab_number)
{
    Candidates chosen = {0};
    for (int i = 0; i < all->n; i++) {
        const char *title = title_of(worksheet, all->columns[i]);
        const size_t n_stem = stem_of(worksheet->system)(title);
        int n_numbers = 0;
        const int is_chosen =
            wanted != NULL ? strcmp(title, wanted) == 0 ||
                                 (strlen(wanted) == n_stem && strncmp(title, wanted, n_stem) == 0)
                           : has_number(title, n_stem, lab_number, &n_numbers) ||
                                 (all->n == 1 && (n_numbers == 0 || lab_number < 0));
        if (is_chosen) {
            chosen.columns[chosen.n++] = all->columns[i];
        }
    }
    return chosen;
}

// Returns -1 after one message.
static int choice_fault(const Worksheet *worksheet, const Candidates *all, int n_chosen,
                        const char *wanted, int lab_number)
{
    char titles[600] = "", what[200];
    size_t length = 0;
    for (int i = 0; i < all->n && length < sizeof titles - 1; i++) {
        length += (size_t)snprintf(titles + length, sizeof titles - length, "%s\"%s\"",
                                   i > 0 ? ", " : "", title_of(worksheet, all->columns[i]));
    }
    if (all->n == 0) {
        return sheet_fault(worksheet->path, 1, "found no column \"%s\"", wanted);
    }
    if (wanted != NULL) {
        snprintf(what, sizeof what, "%s column of grades \"%.100s\"",
                 n_chosen > 1 ? "more than one" : "no", wanted);
    } else {
        snprintf(what, sizeof what, "%d columns of grades, of which %s the number %d", all->n,
                 n_chosen > 1 ? "more than one has" : "none has", lab_number);
    }
    return sheet_fault(worksheet->path, 1, "found %s; say which with COLUMN=, one of these: %s",
                       what, titles);
}

// ---- What goes with it ------------------------------------------------------------------------

// The first number of a text, the part of a title with the maximum; "" where that is NULL.
static void number_take(const char *at, char maximum[WORKSHEET_MAXIMUM_BYTES])
{
    at = at != NULL ? at + strcspn(at, "0123456789|>") : "";
    snprintf(maximum, WORKSHEET_MAXIMUM_BYTES, "%.*s", (int)strspn(at, "0123456789.,"), at);
}

static void maximum_find(Worksheet *worksheet)
{
    const char *title = title_of(worksheet, worksheet->grade_column);
    const Participant *points = NULL;
    switch (worksheet->system) {
    case LIST_CANVAS:
        points = points_possible(worksheet);
        snprintf(worksheet->maximum, sizeof worksheet->maximum, "%s",
                 points != NULL ? points->cells[worksheet->grade_column] : "");
        break;
    case LIST_BLACKBOARD:
        number_take(strrchr(title, '['), worksheet->maximum);
        break;
    case LIST_BRIGHTSPACE:
        number_take(strstr(title, "MaxPoints:"), worksheet->maximum);
        break;
    default:
        worksheet->maximum_column = worksheet_column(worksheet, maximum_titles);
    }
}

// A column of another assignment would overwrite what was graded since the list was downloaded.
static int is_uploaded(const Worksheet *worksheet, int column)
{
    const char *title = title_of(worksheet, column);
    if (column == worksheet->grade_column) {
        return 1;
    }
    switch (worksheet->system) {
    case LIST_CANVAS:
        return worksheet_has_title(worksheet, column, canvas_titles);
    case LIST_BLACKBOARD:
        return blackboard_stem(title) == 0;
    case LIST_BRIGHTSPACE:
        return strstr(title, " Grade") == NULL;
    default:
        return 1;
    }
}

int list_columns_find(Worksheet *worksheet, const char *wanted, int lab_number)
{
    worksheet->grade_column = worksheet->maximum_column = -1;
    worksheet->system = system_find(worksheet);
    const Candidates all = candidates_find(worksheet, wanted);
    const Candidates chosen = candidates_choose(worksheet, &all, wanted, lab_number);
    const int is_simple =
        wanted == NULL && (worksheet->system == LIST_OTHER || worksheet->system == LIST_MOODLE);
    if (is_simple || (all.n == 0 && wanted == NULL)) {
        worksheet->grade_column = all.n > 0 ? all.columns[0] : -1;
    } else if (chosen.n == 1) {
        worksheet->grade_column = chosen.columns[0];
    } else if (wanted != NULL || lab_number >= 0) {
        return choice_fault(worksheet, &all, chosen.n, wanted, lab_number);
    }
    if (worksheet->grade_column >= 0) {
        maximum_find(worksheet);
        for (int i = 0; i < worksheet->n_columns; i++) {
            worksheet->is_uploaded[i] = (char)is_uploaded(worksheet, i);
        }
    }
    return 0;
}
