// Telling of corrections, in a line (see corrections.h).
#include "corrections.h"

#include <string.h>

int corrections_has(const Gradebook *gradebook, const Row *row)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        if (corrections->all[i].row == row) {
            return 1;
        }
    }
    return 0;
}

int corrections_count_waiting(const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    int n = 0;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        n += corrections->all[i].has_points && !corrections->all[i].is_applied;
    }
    return n;
}

void correction_change_write(FILE *file, const Correction *correction)
{
    if (correction->task == NULL) {
        return;
    }
    fputs(correction->check != NULL ? correction->check : correction->task, file);
    if (correction->is_applied) {
        fprintf(file, ": %d to %d (%+d)", correction->before, correction->after,
                correction->after - correction->before);
    } else if (correction->has_points) {
        fprintf(file, ": %s%d not applied, as nothing was graded",
                correction->is_relative && correction->points >= 0 ? "+" : "", correction->points);
    }
}

static int is_of(const Correction *correction, const Row *row, const Participant *participant)
{
    return row != NULL ? correction->row == row
                       : participant != NULL && correction->participant == participant;
}

void corrections_write(FILE *file, const Gradebook *gradebook, const Row *row,
                       const Participant *participant)
{
    const Corrections *corrections = gradebook->corrections;
    const char *between = "";
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (!is_of(correction, row, participant)) {
            continue;
        }
        fputs(between, file);
        correction_change_write(file, correction);
        fprintf(file, "%s%s",
                correction->task != NULL && correction->comment[0] != '\0' ? ": " : "",
                correction->comment);
        if (correction->task == NULL && correction->comment[0] == '\0') {
            fprintf(file, "more time until %s", correction->until);
        }
        between = "; ";
    }
}

const char *corrections_until(const Gradebook *gradebook, const Row *row,
                              const Participant *participant)
{
    const Corrections *corrections = gradebook->corrections;
    const char *last = "";
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (is_of(correction, row, participant) && strcmp(correction->until, last) > 0) {
            last = correction->until;
        }
    }
    return last;
}
