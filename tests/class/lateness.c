// Who was late, and what it costs (see lateness.h).
#include "lateness.h"

#include "class_page.h"
#include "complain.h"
#include "corrections.h"
#include "html.h"
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
        lateness->limit = limit * unit_of(unit);
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
        complain(
            "gradebook: LATE: found \"%s\", expected points or percent, for each day or hour or "
            "once, and how late it may be, such as 10%%/day,2days or 5/hour or 20%%,1week",
            late);
        return -1;
    }
    return 0;
}

void lateness_free(Lateness *lateness)
{
    free(lateness->rows);
    *lateness = (Lateness){0};
}

// ---- When --------------------------------------------------------------------------------------

// The column of a list that says when, the instructor's own before Moodle's; -1: none.
static int time_column(const Worksheet *worksheet)
{
    static const char *const own[] = {"handed in", NULL};
    static const char *const moodle[] = {"Last modified (submission)", "Zuletzt geändert (Abgabe)",
                                         NULL};
    if (worksheet == NULL) {
        return -1;
    }
    const int column = worksheet_column(worksheet, own);
    return column >= 0 ? column : worksheet_column(worksheet, moodle);
}

// Of a team each member has a time: the last counts.
static void time_take(LateRow *late, time_t moment)
{
    late->handed_in = !late->has_time || moment > late->handed_in ? moment : late->handed_in;
    late->has_time = 1;
}

// The times of the list. Returns 0, or -1 after one message.
static int list_read(Lateness *lateness, const Gradebook *gradebook, const Worksheet *worksheet)
{
    const int column = time_column(worksheet);
    for (int i = 1; column >= 0 && i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        const char *cell = participant->cells[column];
        time_t moment;
        if (participant->row == NULL || cell[0] == '\0' || strcmp(cell, "-") == 0) {
            continue;
        }
        if (moment_read(cell, &moment) != 0) {
            complain("gradebook: %s: line %d, \"%s\": found \"%s\", expected a time such as "
                     "2026-11-25 23:05",
                     worksheet->path, i + 1, worksheet->participants[0].cells[column], cell);
            return -1;
        }
        time_take(&lateness->rows[participant->row - gradebook->rows], moment);
    }
    return 0;
}

// More time, to the end of that day; else the deadline.
static time_t due_of(const Lateness *lateness, const Gradebook *gradebook, const Row *row)
{
    char text[32];
    time_t extended;
    const char *until = corrections_until(gradebook, row, NULL);
    snprintf(text, sizeof text, "%s 23:59", until);
    return moment_read(text, &extended) == 0 && extended > lateness->due ? extended : lateness->due;
}

// ---- Points ------------------------------------------------------------------------------------

static int points_off(const Lateness *lateness, const LateRow *late, int score, int max_score)
{
    long n_units = 1;
    if (!lateness->takes_points || !lateness_is_late(late)) {
        return 0;
    }
    if (!late->is_marked) {
        if (lateness->limit > 0 && late->seconds > lateness->limit) {
            return score;
        }
        n_units = lateness->unit > 0 ? (late->seconds + lateness->unit - 1) / lateness->unit : 1;
    }
    const double each =
        lateness->is_percent ? lateness->amount * max_score / 100.0 : lateness->amount;
    const double off = (double)n_units * each + 0.5;
    return off < score ? (int)off : score;
}

static void row_judge(const Lateness *lateness, const Gradebook *gradebook, const Row *row,
                      LateRow *late)
{
    time_t moment;
    if (!late->has_time && moment_read(row->entrant->time, &moment) == 0) {
        time_take(late, moment);
    }
    late->due = due_of(lateness, gradebook, row);
    if (late->has_time) {
        // All of the minute that was named is in time.
        const long seconds = (long)(late->handed_in - late->due);
        late->seconds = seconds >= MINUTE ? seconds : 0;
    } else {
        // The system knows nothing of an extension given here.
        late->is_marked = row->entrant->is_late && late->due == lateness->due;
    }
    if (row_is_graded(row)) {
        late->off = points_off(lateness, late, row->score, gradebook->max_score);
    }
}

int lateness_apply(Lateness *lateness, Gradebook *gradebook, const Worksheet *worksheet)
{
    lateness->rows = calloc((size_t)gradebook->n_rows + 1, sizeof *lateness->rows);
    if (lateness->rows == NULL) {
        complain("gradebook: %s: out of memory", gradebook->folder);
        return -1;
    }
    if (list_read(lateness, gradebook, worksheet) != 0) {
        return -1;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        Row *row = &gradebook->rows[i];
        row_judge(lateness, gradebook, row, &lateness->rows[i]);
        row->score -= lateness->rows[i].off;
    }
    gradebook->lateness = lateness;
    return 0;
}

// ---- Telling -----------------------------------------------------------------------------------

const LateRow *lateness_of(const Gradebook *gradebook, const Row *row)
{
    return gradebook->lateness != NULL ? &gradebook->lateness->rows[row - gradebook->rows] : NULL;
}

int lateness_is_late(const LateRow *late)
{
    return late->seconds > 0 || late->is_marked;
}

// "2 days", or nothing of none; before it a blank where something stands there.
static int part_write(char *text, int length, long n, const char *one, const char *many)
{
    return n == 0 ? 0
                  : snprintf(text + length, (size_t)(LATENESS_BYTES - length), "%s%ld %s",
                             length > 0 ? " " : "", n, n == 1 ? one : many);
}

void lateness_duration(long seconds, char text[LATENESS_BYTES])
{
    const long days = seconds / DAY, hours = seconds % DAY / HOUR;
    text[0] = '\0';
    int length = part_write(text, 0, days, "day", "days");
    length += part_write(text, length, hours, "h", "h");
    // Beside days and hours minutes say nothing.
    if (days == 0 || hours == 0) {
        part_write(text, length, seconds % HOUR / MINUTE, "min", "min");
    }
}

// What follows "handed in": when, and how late.
static void when_write(FILE *file, const LateRow *late)
{
    char when[MOMENT_BYTES], by[LATENESS_BYTES];
    if (late->is_marked) {
        fputs("late, as the course system says, at a time that it does not say", file);
        return;
    }
    moment_write(late->handed_in, when);
    lateness_duration(late->seconds, by);
    fprintf(file, "%s, %s late", when, by);
}

void lateness_write(FILE *file, const Gradebook *gradebook, const Row *row)
{
    const LateRow *late = lateness_of(gradebook, row);
    if (late == NULL || !lateness_is_late(late)) {
        return;
    }
    fputs("handed in ", file);
    when_write(file, late);
    if (gradebook->lateness->takes_points) {
        fprintf(file, ": %d point%s off", late->off, late->off == 1 ? "" : "s");
    }
}

static int is_unknown(const LateRow *late)
{
    return !late->has_time && !late->is_marked;
}

void lateness_tell(const Gradebook *gradebook)
{
    const Lateness *lateness = gradebook->lateness;
    int n_late = 0, n_unknown = 0, n_off = 0;
    char due[MOMENT_BYTES];
    if (lateness == NULL) {
        return;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        n_late += lateness_is_late(&lateness->rows[i]);
        n_unknown += is_unknown(&lateness->rows[i]);
        n_off += lateness->rows[i].off;
    }
    moment_write(lateness->due, due);
    printf("Due %s: %d late", due, n_late);
    if (lateness->takes_points) {
        printf(", %d points off", n_off);
    }
    printf("\n");
    if (n_unknown > 0) {
        printf(
            "of %d submissions no time is known: they count as handed in time (see class.html)\n",
            n_unknown);
    }
}

static void late_row_write(FILE *page, const Gradebook *gradebook, const Row *row,
                           const LateRow *late)
{
    char due[MOMENT_BYTES];
    fputs("<tr><td class=\"name\">", page);
    class_name_write(page, row);
    fputs("</td><td>", page);
    when_write(page, late);
    if (late->due != gradebook->lateness->due) {
        moment_write(late->due, due);
        fprintf(page, " <span class=\"soft\">(due %s)</span>", due);
    }
    if (row_is_graded(row)) {
        fprintf(page,
                "</td><td class=\"number\">%d</td><td class=\"number short\">%+d</td>"
                "<td class=\"number\">%d</td></tr>\n",
                row->score + late->off, -late->off, row->score);
    } else {
        fputs("</td><td></td><td></td><td></td></tr>\n", page);
    }
}

static void unknown_write(FILE *page, const Gradebook *gradebook)
{
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (!is_unknown(&gradebook->lateness->rows[i])) {
            continue;
        }
        fputs(n++ == 0
                  ? "<p class=\"soft\">Nobody knows when these were handed in, so they count as "
                    "handed in time. A column <code>handed in</code> in the list of "
                    "participants would say it.</p>\n<div class=\"card\"><p class=\"names\">"
                  : " &middot; ",
              page);
        class_name_write(page, &gradebook->rows[i]);
    }
    fputs(n > 0 ? "</p></div>\n" : "", page);
}

void lateness_class_write(FILE *page, const Gradebook *gradebook)
{
    const Lateness *lateness = gradebook->lateness;
    char due[MOMENT_BYTES];
    int n = 0;
    if (lateness == NULL) {
        return;
    }
    moment_write(lateness->due, due);
    fprintf(page,
            "<h2 class=\"section\" id=\"late\">Handed in late</h2>\n<p class=\"soft\">Due %s.",
            due);
    if (lateness->takes_points) {
        fputs(" All scores on this page are those after what lateness costs. Tasks keep their "
              "points.",
              page);
    }
    fputs("</p>\n", page);
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (!lateness_is_late(&lateness->rows[i])) {
            continue;
        }
        if (n++ == 0) {
            fputs("<div class=\"card\"><table><thead><tr><th>Submission</th><th>Handed in</th>"
                  "<th class=\"number\">Score before</th><th class=\"number\">Off</th>"
                  "<th class=\"number\">Score</th></tr></thead><tbody>\n",
                  page);
        }
        late_row_write(page, gradebook, &gradebook->rows[i], &lateness->rows[i]);
    }
    fputs(n > 0 ? "</tbody></table></div>\n" : "<div class=\"card\"><p>Nobody.</p></div>\n", page);
    unknown_write(page, gradebook);
}
