// Telling of corrections, in a line (see corrections.h).
#include "corrections.h"

#include <string.h>

const Correction *corrections_next(const Gradebook *gradebook, const Row *row,
                                   const Participant *participant, const Correction *before)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = before != NULL ? (int)(before - corrections->all) + 1 : 0;
         corrections != NULL && i < corrections->n; i++) {
        const Correction *next = &corrections->all[i];
        if (row != NULL ? next->row == row
                        : participant != NULL && next->participant == participant) {
            return next;
        }
    }
    return NULL;
}

int corrections_has(const Gradebook *gradebook, const Row *row)
{
    return corrections_next(gradebook, row, NULL, NULL) != NULL;
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

void corrections_write(FILE *file, const Gradebook *gradebook, const Row *row,
                       const Participant *participant)
{
    const Correction *correction = NULL;
    const char *between = "";
    while ((correction = corrections_next(gradebook, row, participant, correction)) != NULL) {
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
    const Correction *correction = NULL;
    const char *last = "";
    while ((correction = corrections_next(gradebook, row, participant, correction)) != NULL) {
        last = strcmp(correction->until, last) > 0 ? correction->until : last;
    }
    return last;
}
