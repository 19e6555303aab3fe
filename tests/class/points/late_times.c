// Finding when rows were handed in (see lateness.h). The first of these counts that says
// anything: the instructor's column of the list, the instructor's decisions, Moodle's column of
// the list, what the export has.
#include "lateness.h"

#include "complain.h"
#include "course_system.h"
#include "decisions.h"
#include "moment.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Of a team each member has a time: the last counts.
static void time_take(LateRow *late, time_t moment)
{
    late->handed_in = !late->has_time || moment > late->handed_in ? moment : late->handed_in;
    late->has_time = 1;
}

// Nobody knows when, for this reason. Returns 0, or -1 after one message.
__attribute__((format(printf, 2, 3))) static int unknown_set(LateRow *late, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *before = late->unknown;
    const int length = vasprintf(&late->unknown, format, arguments);
    va_end(arguments);
    free(before);
    late->has_time = 0;
    if (length < 0) {
        late->unknown = NULL;
        complain("gradebook: out of memory");
    }
    return length < 0 ? -1 : 0;
}

// ---- What the instructor says ------------------------------------------------------------------

// A time, "in time" or "late". Returns 0, or -1 for anything else.
static int said_read(const char *text, LateRow *late)
{
    time_t moment;
    late->is_said = 1;
    if (moment_read(text, &moment) == 0) {
        time_take(late, moment);
        return 0;
    }
    late->is_marked |= strcasecmp(text, "late") == 0;
    return late->is_marked || strcasecmp(text, "in time") == 0 ? 0 : -1;
}

static int said_fault(const char *path, int line, const char *text)
{
    return sheet_fault(path, line,
                       "\"handed in\": found \"%.200s\", expected a time such as 2026-11-25 23:05, "
                       "\"in time\" or \"late\"",
                       text);
}

static int own_column(const Worksheet *worksheet)
{
    static const char *const titles[] = {"handed in", "abgegeben", NULL};
    return worksheet != NULL ? worksheet_column(worksheet, titles) : -1;
}

static int own_column_read(Lateness *lateness, const Gradebook *gradebook,
                           const Worksheet *worksheet)
{
    const int column = own_column(worksheet);
    for (int i = 1; column >= 0 && i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        const char *cell = participant->cells[column];
        if (participant->row != NULL && cell[0] != '\0' && strcmp(cell, "-") != 0 &&
            said_read(cell, &lateness->rows[participant->row - gradebook->rows]) != 0) {
            return said_fault(worksheet->path, i + 1, cell);
        }
    }
    return 0;
}

static int decisions_read(Lateness *lateness, const Decisions *decisions)
{
    for (int i = 0; decisions != NULL && i < decisions->n; i++) {
        const Decision *decision = &decisions->all[i];
        LateRow *late = &lateness->rows[decision->row], said = {.due = late->due};
        if (decision->handed_in[0] == '\0') {
            continue;
        }
        if (said_read(decision->handed_in, &said) != 0) {
            return said_fault(decisions->path, decision->line, decision->handed_in);
        }
        *late = late->is_said ? *late : said;
    }
    return 0;
}

// ---- What a system says ------------------------------------------------------------------------

static int moodle_column(const Worksheet *worksheet)
{
    static const char *const titles[] = {"Last modified (submission)", "Zuletzt geändert (Abgabe)",
                                         NULL};
    return worksheet != NULL ? worksheet_column(worksheet, titles) : -1;
}

static int moodle_read(Lateness *lateness, const Gradebook *gradebook, const Worksheet *worksheet)
{
    const int column = moodle_column(worksheet);
    int result = 0;
    for (int i = 1; column >= 0 && result == 0 && i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        const char *cell = participant->cells[column];
        time_t moment;
        if (participant->row == NULL || cell[0] == '\0' || strcmp(cell, "-") == 0) {
            continue;
        }
        LateRow *late = &lateness->rows[participant->row - gradebook->rows];
        if (late->is_said || late->unknown != NULL) {
            continue;
        }
        if (moment_read(cell, &moment) == 0) {
            time_take(late, moment);
        } else {
            result = unknown_set(late,
                                 "line %d of the list says \"%.200s\", which is no time that the "
                                 "grader can read",
                                 i + 1, cell);
        }
    }
    return result;
}

// What the export says of an entrant.
static int entrant_read(const Lateness *lateness, const Entrant *entrant, LateRow *late)
{
    char shown[MOMENT_BYTES];
    time_t moment;
    const CourseSystem *evidence = course_system(entrant->time_from);
    const int has_time = moment_read(entrant->time, &moment) == 0;
    switch (evidence->time_writer) {
    case WRITER_STUDENT:
        moment_write(has_time ? moment : 0, shown);
        return unknown_set(late, "%s says %s, which a student can set", evidence->time,
                           has_time ? shown : entrant->time);
    case WRITER_SYSTEM:
        if (has_time) {
            time_take(late, moment);
        } else if (entrant->time[0] != '\0') {
            return unknown_set(late,
                               "%s says \"%.200s\", which is no time that the grader can read",
                               evidence->title, entrant->time);
        } else if (!entrant->is_late) {
            late->is_unmarked = 1;
        } else if (late->due == lateness->due) {
            late->is_marked = 1;
        } else {
            // The system knows nothing of an extension given here.
            moment_write(late->due, shown);
            return unknown_set(late,
                               "%s marks it as late, but says no time, and you gave time until %s",
                               evidence->title, shown);
        }
        return 0;
    default:
        return entrant->time[0] != '\0'
                   ? unknown_set(late, "nobody knows when it was handed in: %s", entrant->time)
                   : unknown_set(late, "nothing says when it was handed in");
    }
}

// ---- All ---------------------------------------------------------------------------------------

// Would a row be entered, if its time were known? Whose it is comes first where the list has times.
static int needs_time(const Gradebook *gradebook, const Worksheet *worksheet, const Row *row)
{
    if (!row_is_counted(gradebook, row)) {
        return 0;
    }
    if (worksheet == NULL) {
        return 1;
    }
    const Entered *entered = &worksheet->entered[row - gradebook->rows];
    const int has_times = own_column(worksheet) >= 0 || moodle_column(worksheet) >= 0;
    return entered->left_out == NULL && (!has_times || entered->n_participants > 0);
}

// Attempts are in the order of their times: one without may be later than the row that counts.
static const Entrant *untimed_attempt(const Gradebook *gradebook, const Row *row)
{
    const int n_before = (int)(row - gradebook->rows);
    for (int i = 1; i < row->entrant->attempt && i <= n_before; i++) {
        const Entrant *other = row[-i].entrant;
        if (row->entrant->time_from != SYSTEM_NONE && other->time_from == SYSTEM_NONE &&
            row_that_counts(gradebook, row - i) == row) {
            return other;
        }
    }
    return NULL;
}

static int row_find(const Lateness *lateness, const Gradebook *gradebook,
                    const Worksheet *worksheet, const Row *row, LateRow *late)
{
    if (!late->is_said && !late->has_time && late->unknown == NULL &&
        entrant_read(lateness, row->entrant, late) != 0) {
        return -1;
    }
    const Entrant *other = untimed_attempt(gradebook, row);
    if (!late->is_said && other != NULL &&
        unknown_set(late, "another attempt, of which nobody knows the time, may be later: \"%s\"",
                    other->entry) != 0) {
        return -1;
    }
    if (late->unknown != NULL && !needs_time(gradebook, worksheet, row)) {
        free(late->unknown);
        late->unknown = NULL;
    }
    const char *why_not =
        worksheet != NULL ? worksheet->entered[row - gradebook->rows].why_not : NULL;
    return late->unknown != NULL && why_not != NULL
               ? unknown_set(late, "%s; %s", why_not, late->unknown)
               : 0;
}

int late_times_find(Lateness *lateness, const Gradebook *gradebook, const Worksheet *worksheet)
{
    int result = own_column_read(lateness, gradebook, worksheet) != 0 ||
                         decisions_read(lateness, gradebook->decisions) != 0 ||
                         moodle_read(lateness, gradebook, worksheet) != 0
                     ? -1
                     : 0;
    for (int i = 0; result == 0 && i < gradebook->n_rows; i++) {
        result = row_find(lateness, gradebook, worksheet, &gradebook->rows[i], &lateness->rows[i]);
    }
    return result;
}
