// What has changed scores: corrections by hand, late work, another grading (see class_page.h).
#include "class_page.h"
#include "corrections.h"
#include "html.h"
#include "lateness.h"
#include "moment.h"
#include "participant_cells.h"

#include <stdlib.h>

// ---- Old and new -----------------------------------------------------------------------------

void class_changes_write(FILE *page, const Gradebook *gradebook)
{
    int n_compared = 0, n_up = 0, n_down = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        const int compared = row->has_old_score && row_is_graded(row);
        n_compared += compared;
        n_up += compared && row->score > row->old_score;
        n_down += compared && row->score < row->old_score;
    }
    if (!gradebook->has_old_scores) {
        return;
    }
    fprintf(page,
            "<h2 class=\"section\" id=\"changes\">Old and new scores</h2>\n<p class=\"soft\">Of %d "
            "that were graded before, %d have more now, %d less.</p>\n",
            n_compared, n_up, n_down);
    if (n_up + n_down == 0) {
        return;
    }
    fputs("<div class=\"card\">\n", page);
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->has_old_score && row_is_graded(row) && row->score != row->old_score) {
            fputs("<div class=\"count\"><div>", page);
            class_name_write(page, row);
            fprintf(page, "</div><span class=\"number\">%d &rarr; %d</span><b class=\"number %s\">",
                    row->old_score, row->score, row->score < row->old_score ? "short" : "gain");
            fprintf(page, "%+d</b></div>\n", row->score - row->old_score);
        }
    }
    fputs("</div>\n", page);
}

// ---- Corrections -----------------------------------------------------------------------------

// Change, comment, until.
static void cells_write(FILE *page, const Correction *correction)
{
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
    fputs("</td></tr>\n", page);
    free(change);
}

void class_correction_rows_write(FILE *page, const Gradebook *gradebook, const Row *row)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        if (corrections->all[i].row == row) {
            fputs("<tr>", page);
            cells_write(page, &corrections->all[i]);
        }
    }
}

static void corrections_class_write(FILE *page, const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        fputs("<tr><td class=\"name\">", page);
        if (correction->row != NULL) {
            class_name_write(page, correction->row);
        } else {
            char name[ENTRY_NAME_BYTES];
            participant_name(corrections->worksheet, correction->participant, name);
            html_line(page, name);
        }
        fputs("</td>", page);
        cells_write(page, correction);
    }
}

void class_corrections_write(FILE *page, const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    if (corrections == NULL || corrections->n == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"corrections\">Corrections by hand</h2>\n"
          "<p class=\"soft\">All scores on this page contain them. The students' reports do not: "
          "<code>make feedback</code> adds them to the copies that it gives back.</p>\n"
          "<div class=\"card\"><table><thead><tr><th>Submission</th><th>Change</th>"
          "<th>Comment</th><th>More time until</th></tr></thead><tbody>\n",
          page);
    corrections_class_write(page, gradebook);
    fputs("</tbody></table></div>\n", page);
}

// ---- Late work -------------------------------------------------------------------------------

static void late_row_write(FILE *page, const Gradebook *gradebook, const Row *row,
                           const LateRow *late)
{
    char due[MOMENT_BYTES];
    fputs("<tr><td class=\"name\">", page);
    class_name_write(page, row);
    fputs("</td><td>", page);
    lateness_when_write(page, late);
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

void class_late_write(FILE *page, const Gradebook *gradebook)
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
    const char *system = lateness_marks_find(gradebook, &n);
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
