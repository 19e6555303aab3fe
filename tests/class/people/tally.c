// Counting what became of all entries (see tally.h). Read next: gradebook_tool.c, class_page.c.
#include "tally.h"

const char *tally_why_undecided(const Gradebook *gradebook, const Worksheet *worksheet,
                                const Row *row)
{
    const char *unknown = row->time_unknown;
    return unknown != NULL     ? unknown
           : worksheet != NULL ? worksheet->entered[row - gradebook->rows].why_not
                               : NULL;
}

Tally tally_count(const Gradebook *gradebook, const Worksheet *worksheet, int n_alike)
{
    Tally tally = {.n_entries = gradebook->n_rows,
                   .n_passed_over = gradebook->roster.n_passed_over,
                   .has_list = worksheet != NULL};
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row_that_counts(gradebook, row) != row) {
            tally.n_superseded++;
        } else if (row->status == ROW_NOT_GRADED) {
            tally.n_not_graded++;
        } else if (worksheet != NULL && worksheet->entered[i].left_out != NULL) {
            tally.n_left_out++;
        } else if (tally_why_undecided(gradebook, worksheet, row) != NULL) {
            tally.n_undecided++;
        } else if (row->status == ROW_NOTHING) {
            tally.n_nothing++;
        } else {
            tally.n_done++;
        }
    }
    if (worksheet == NULL) {
        tally.n_alike = n_alike;
        return tally;
    }
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        tally.n_without +=
            participant->row == NULL && !participant->is_fitted && !participant->is_nobody;
    }
    return tally;
}

int tally_has_lost(const Tally *tally)
{
    return tally->n_not_graded > 0 || tally->n_passed_over > 0 || tally->n_undecided > 0;
}

void tally_write(FILE *file, const Tally *tally)
{
    fprintf(file, "%d of %d graded", tally->n_done, tally->n_entries);
    if (tally->has_list) {
        fprintf(file, " and entered; %d without submission", tally->n_without);
    }
    fprintf(file, "; %d passed over; %d with nothing of this lab", tally->n_passed_over,
            tally->n_nothing);
    if (tally->n_superseded > 0) {
        fprintf(file, "; %d earlier attempts", tally->n_superseded);
    }
    if (tally->n_left_out > 0) {
        fprintf(file, "; %d left out by you", tally->n_left_out);
    }
    if (tally->n_not_graded > 0) {
        fprintf(file, "; %d not graded", tally->n_not_graded);
    }
    fprintf(file, "; %d to be decided by you", tally->n_undecided + tally->n_alike);
}
