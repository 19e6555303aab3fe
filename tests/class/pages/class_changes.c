// What has changed scores: another grading, corrections by hand, late work (see class_page.h).
#include "class_page.h"
#include "corrections.h"
#include "html.h"
#include "lateness.h"
#include "moment.h"
#include "participant_cells.h"
#include "template.h"

#include <stdlib.h>

// ---- Old and new -----------------------------------------------------------------------------

json_t *class_compared(const Gradebook *gradebook)
{
    int n_compared = 0, n_up = 0, n_down = 0;
    if (!gradebook->has_old_scores) {
        return json_null();
    }
    json_t *changed = json_array();
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const int change = row->score - row->old_score;
        if (!row->has_old_score || !row_is_graded(row)) {
            continue;
        }
        n_compared++;
        n_up += change > 0;
        n_down += change < 0;
        if (change != 0) {
            char text[16];
            snprintf(text, sizeof text, "%+d", change);
            json_t *json = class_row(row);
            json_object_update_new(json, json_pack("{s:i, s:i, s:s, s:s}", "old_score",
                                                   row->old_score, "score", row->score, "level",
                                                   change < 0 ? "short" : "gain", "change", text));
            json_array_append_new(changed, json);
        }
    }
    return json_pack("{s:i, s:i, s:i, s:o}", "n_compared", n_compared, "n_up", n_up, "n_down",
                     n_down, "changed", changed);
}

// ---- Corrections -----------------------------------------------------------------------------

// Change, comment, until.
static void cells_write(FILE *page, const void *about)
{
    const Correction *correction = about;
    char *change = NULL;
    size_t length;
    FILE *stream = open_memstream(&change, &length);
    if (stream != NULL) {
        correction_change_write(stream, correction);
        fclose(stream);
    }
    // Task and numbers are ours, the rest is the instructor's.
    fprintf(page, "<td>%s</td><td>", change != NULL ? change : "");
    html_message(page, correction->comment);
    fputs("</td><td>", page);
    html_line(page, correction->until);
    fputs("</td>", page);
    free(change);
}

void class_correction_rows_write(FILE *page, const Gradebook *gradebook, const Row *row)
{
    const Correction *correction = NULL;
    while ((correction = corrections_next(gradebook, row, NULL, correction)) != NULL) {
        fputs("<tr>", page);
        cells_write(page, correction);
        fputs("</tr>\n", page);
    }
}

static void line_write(FILE *page, const void *about)
{
    html_line(page, about);
}

json_t *class_corrections(const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    if (corrections == NULL || corrections->n == 0) {
        return json_null();
    }
    json_t *corrected = json_array();
    for (int i = 0; i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        char name[ENTRY_NAME_BYTES];
        json_t *json = correction->row != NULL ? class_row(correction->row) : json_object();
        if (correction->row == NULL) {
            participant_name(corrections->worksheet, correction->participant, name);
            json_object_set_new(json, "who", template_markup(line_write, name));
        }
        json_object_set_new(json, "cells", template_markup(cells_write, correction));
        json_array_append_new(corrected, json);
    }
    return json_pack("{s:o}", "corrected", corrected);
}

// ---- Late work -------------------------------------------------------------------------------

static void when_write(FILE *file, const void *late)
{
    lateness_when_write(file, late);
}

static json_t *late_row_of(const Gradebook *gradebook, const Row *row, const LateRow *late)
{
    char own_due[MOMENT_BYTES] = "", off[16];
    if (late->due != gradebook->lateness->due) {
        moment_write(late->due, own_due);
    }
    snprintf(off, sizeof off, "%+d", -late->off);
    json_t *json = class_row(row);
    json_object_update_new(
        json, json_pack("{s:o, s:s, s:b, s:i, s:s, s:i}", "when", template_markup(when_write, late),
                        "own_due", own_due, "is_graded", row_is_graded(row), "before",
                        row->score + late->off, "off", off, "score", row->score));
    return json;
}

json_t *class_late(const Gradebook *gradebook)
{
    const Lateness *lateness = gradebook->lateness;
    char due[MOMENT_BYTES];
    int n_unmarked = 0;
    if (lateness == NULL) {
        return json_null();
    }
    json_t *rows = json_array();
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (lateness_is_late(&lateness->rows[i])) {
            json_array_append_new(rows,
                                  late_row_of(gradebook, &gradebook->rows[i], &lateness->rows[i]));
        }
    }
    moment_write(lateness->due, due);
    const char *system = lateness_marks_find(gradebook, &n_unmarked);
    return json_pack("{s:s, s:b, s:s*, s:i, s:o}", "due", due, "takes_points",
                     lateness->takes_points, "system", system, "n_unmarked", n_unmarked,
                     "late_rows", rows);
}
