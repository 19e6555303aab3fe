// Telling of lateness: in a line, on the terminal (see lateness.h).
#include "lateness.h"

#include "course_system.h"
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

void lateness_when_write(FILE *file, const LateRow *late)
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
    lateness_when_write(file, late);
    if (gradebook->lateness->takes_points) {
        fprintf(file, ": %d point%s off", late->off, late->off == 1 ? "" : "s");
    }
}

const char *lateness_marks_find(const Gradebook *gradebook, int *n)
{
    const char *system = NULL;
    *n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (gradebook->lateness->rows[i].is_unmarked) {
            system = course_system(gradebook->rows[i].entrant->time_from)->title;
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
    const char *system = lateness_marks_find(gradebook, &n_unmarked);
    if (system != NULL) {
        printf("%s writes no times: %d without its mark of late work count as in time. That holds "
               "only if your assignment there has the same deadline\n",
               system, n_unmarked);
    }
}
