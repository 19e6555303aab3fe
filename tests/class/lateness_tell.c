// Telling of lateness: in a line, on the terminal, on the class page (see lateness.h).
#include "lateness.h"

#include "class_page.h"
#include "evidence.h"
#include "moment.h"

#include <stdio.h>

enum { MINUTE = 60, HOUR = 60 * MINUTE, DAY = 24 * HOUR };

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
        fputs(late->is_said ? "late"
                            : "late, as the course system says, at a time that it does not say",
              file);
        return;
    }
    moment_write(late->handed_in, when);
    lateness_duration(late->seconds, by);
    fprintf(file, "%s, %s late", when, by);
}

void lateness_write(FILE *file, const Gradebook *gradebook, const Row *row)
{
    const LateRow *late = lateness_of(gradebook, row);
    if (!lateness_is_late(late)) {
        return;
    }
    fputs("handed in ", file);
    when_write(file, late);
    if (gradebook->lateness->takes_points) {
        fprintf(file, ": %d point%s off", late->off, late->off == 1 ? "" : "s");
    }
}

// A system that writes no times has marked what is late by its own deadline. Its name, and of how
// many that is all that is known; NULL: of none.
static const char *marks_find(const Gradebook *gradebook, int *n)
{
    const char *system = NULL;
    *n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (gradebook->lateness->rows[i].is_unmarked) {
            system = evidence_of(gradebook->rows[i].entrant->time_from)->title;
            (*n)++;
        }
    }
    return system;
}

void lateness_tell(const Gradebook *gradebook)
{
    const Lateness *lateness = gradebook->lateness;
    int n_late = 0, n_unknown = 0, n_off = 0, n_unmarked;
    char due[MOMENT_BYTES];
    if (lateness == NULL) {
        return;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        n_late += lateness_is_late(&lateness->rows[i]);
        n_unknown += lateness->rows[i].unknown != NULL;
        n_off += lateness->rows[i].off;
    }
    moment_write(lateness->due, due);
    printf("Due %s: %d late", due, n_late);
    if (lateness->takes_points) {
        printf(", %d points off", n_off);
    }
    printf(n_unknown > 0 ? ", of %d nobody knows\n" : "\n", n_unknown);
    const char *system = marks_find(gradebook, &n_unmarked);
    if (system != NULL) {
        printf("%s writes no times: %d without its mark of late work count as in time. That holds "
               "only if your assignment there has the same deadline\n",
               system, n_unmarked);
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
    const char *system = marks_find(gradebook, &n);
    if (system != NULL) {
        fprintf(page,
                " %s writes no times: %d submissions without its mark of late work count as in "
                "time. That holds only if the assignment there has the same deadline.",
                system, n);
    }
    fputs("</p>\n", page);
    n = 0;
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
}
