// Who was late, and what it costs (see lateness.h). Read next: late_times.c, lateness_tell.c.
#include "lateness.h"

#include "complain.h"
#include "corrections.h"
#include "moment.h"

#include <stdlib.h>
#include <string.h>

enum { MINUTE = 60, HOUR = 60 * MINUTE, DAY = 24 * HOUR };

// ---- What make was given -----------------------------------------------------------------------

static int due_read(const char *due, time_t *moment)
{
    static const char expected[] = "expected a day, a time and, where it is not this machine's, a "
                                   "zone, such as \"2026-11-25 23:59 Europe/Berlin\"";
    char text[64], zone[64] = "", more[2] = "";
    int n_text = 0;
    sscanf(due, "%*s %*s%n", &n_text);
    if (n_text == 0 || n_text >= (int)sizeof text) {
        complain("gradebook: DUE: found \"%s\", %s", due, expected);
        return -1;
    }
    snprintf(text, sizeof text, "%.*s", n_text, due);
    sscanf(due + n_text, "%63s %1s", zone, more);
    if (more[0] != '\0' || moment_zone_set(zone[0] != '\0' ? zone : NULL) != 0) {
        complain(
            "gradebook: DUE: found the zone \"%s\", expected one such as Europe/Berlin, UTC or "
            "+01:00",
            due + n_text + 1);
        return -1;
    }
    if (moment_read(text, moment) != 0) {
        complain("gradebook: DUE: found \"%s\", %s", due, expected);
        return -1;
    }
    return 0;
}

// Seconds of "day", "hours" and so on; 0 where it is no unit.
static long unit_of(const char *word)
{
    static const struct {
        const char *one, *many;
        long seconds;
    } units[] = {
        {"minute", "minutes", MINUTE},
        {"hour", "hours", HOUR},
        {"day", "days", DAY},
        {"week", "weeks", 7 * DAY},
    };
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        if (strcmp(word, units[i].one) == 0 || strcmp(word, units[i].many) == 0) {
            return units[i].seconds;
        }
    }
    return 0;
}

// "10%/day,2days" and its shorter forms. Returns 0, or -1.
static int late_read(const char *late, Lateness *lateness)
{
    char unit[16] = "";
    int length = 0, limit;
    if (sscanf(late, "%4d%n", &lateness->amount, &length) != 1 || lateness->amount < 0) {
        return -1;
    }
    late += length;
    lateness->is_percent = *late == '%';
    late += lateness->is_percent;
    if (*late == '/') {
        length = 0;
        if (sscanf(late, "/%15[a-z]%n", unit, &length) != 1 || unit_of(unit) == 0) {
            return -1;
        }
        lateness->unit = unit_of(unit);
        late += length;
    }
    if (*late == ',') {
        length = 0;
        if (sscanf(late, ",%4d%15[a-z]%n", &limit, unit, &length) != 2 || limit < 1 ||
            unit_of(unit) == 0) {
            return -1;
        }
        lateness->limit = limit;
        lateness->limit_unit = unit_of(unit);
        late += length;
    }
    lateness->takes_points = 1;
    return *late == '\0' && (!lateness->is_percent || lateness->amount <= 100) ? 0 : -1;
}

int lateness_read(const char *due, const char *late, Lateness *lateness)
{
    *lateness = (Lateness){0};
    if (due == NULL) {
        complain("gradebook: LATE: found no deadline beside it, expected DUE=\"2026-11-25 23:59\"");
        return -1;
    }
    if (due_read(due, &lateness->due) != 0) {
        return -1;
    }
    if (late != NULL && late_read(late, lateness) != 0) {
        complain("gradebook: LATE: found \"%s\", expected whole points or percent, for each day or "
                 "hour or "
                 "once, and how late it may be, such as 10%%/day,2days or 5/hour or 20%%,1week",
                 late);
        return -1;
    }
    return 0;
}

void lateness_free(Lateness *lateness)
{
    for (int i = 0; lateness->rows != NULL && i < lateness->n_rows; i++) {
        free(lateness->rows[i].unknown);
    }
    free(lateness->rows);
    *lateness = (Lateness){0};
}

// ---- A row -------------------------------------------------------------------------------------

// More time, to the end of that day; else the deadline.
static time_t due_of(const Lateness *lateness, const Gradebook *gradebook, const Row *row)
{
    char text[32];
    time_t extended;
    const char *until = corrections_until(gradebook, row, NULL);
    snprintf(text, sizeof text, "%s 23:59", until);
    return moment_read(text, &extended) == 0 && extended > lateness->due ? extended : lateness->due;
}

const LateRow *lateness_of(const Gradebook *gradebook, const Row *row)
{
    return gradebook->lateness != NULL ? &gradebook->lateness->rows[row - gradebook->rows] : NULL;
}

int lateness_is_late(const LateRow *late)
{
    return late != NULL && (late->seconds > 0 || late->is_marked);
}

// ---- Points ------------------------------------------------------------------------------------

// A minute that was named counts as its beginning: all of 23:59 is in time.
static time_t minute_begin(const LateRow *late)
{
    return late->handed_in - (MINUTE - 1);
}

// How many units have begun since it was due. Days are those of the calendar, whose clocks may have
// gone back or forward between.
static long units_begun(const LateRow *late, long unit)
{
    const time_t handed_in = minute_begin(late);
    long n = (long)(handed_in - late->due) / unit;
    while (handed_in > moment_later(late->due, n, unit)) {
        n++;
    }
    return n;
}

static int points_off(const Lateness *lateness, const LateRow *late, int score, int max_score)
{
    long n_units = 1;
    if (!lateness->takes_points || !lateness_is_late(late)) {
        return 0;
    }
    if (late->has_time) {
        if (lateness->limit > 0 &&
            minute_begin(late) > moment_later(late->due, lateness->limit, lateness->limit_unit)) {
            return score;
        }
        n_units = lateness->unit > 0 ? units_begun(late, lateness->unit) : 1;
    }
    const double each =
        lateness->is_percent ? lateness->amount * max_score / 100.0 : lateness->amount;
    const double off = (double)n_units * each + 0.5;
    return off < score ? (int)off : score;
}

static void row_judge(const Lateness *lateness, const Gradebook *gradebook, Row *row, LateRow *late)
{
    if (late->has_time) {
        const long seconds = (long)(late->handed_in - late->due);
        late->seconds = seconds >= MINUTE ? seconds : 0;
        late->is_marked = late->is_marked && late->seconds == 0;
        late->has_time = !late->is_marked;
    }
    if (row_is_graded(row)) {
        late->off = points_off(lateness, late, row->score, gradebook->max_score);
        row->score -= late->off;
    }
}

int lateness_apply(Lateness *lateness, Gradebook *gradebook, const Worksheet *worksheet)
{
    lateness->rows = calloc((size_t)gradebook->n_rows + 1, sizeof *lateness->rows);
    lateness->n_rows = gradebook->n_rows;
    if (lateness->rows == NULL) {
        complain("gradebook: %s: out of memory", gradebook->folder);
        return -1;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        lateness->rows[i].due = due_of(lateness, gradebook, &gradebook->rows[i]);
    }
    if (late_times_find(lateness, gradebook, worksheet) != 0) {
        return -1;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        row_judge(lateness, gradebook, &gradebook->rows[i], &lateness->rows[i]);
        gradebook->rows[i].time_unknown = lateness->rows[i].unknown;
    }
    gradebook->lateness = lateness;
    return 0;
}
