// What a student is given: the report with what has changed its points (see feedback.h).
#include "feedback.h"

#include "class_page.h"
#include "complain.h"
#include "corrections.h"
#include "html.h"
#include "lateness.h"
#include "path.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

void feedback_report_path(const Gradebook *gradebook, const Row *row, char path[PATH_MAX])
{
    path_make(path, "%s/students/%s/report.html", gradebook->folder, row->entrant->slug);
}

// The section that a report gets behind its head where its points have changed since.
static void changes_section_write(FILE *report, const Gradebook *gradebook, const Row *row)
{
    fprintf(report, "<section id=\"corrections\"><h2 class=\"section\">%s</h2>\n<p>",
            corrections_has(gradebook, row) ? "Corrected by hand" : "Handed in late");
    if (row->score != row->graded_score) {
        fprintf(report, "%d of %d points instead of %d. ", row->score, gradebook->max_score,
                row->graded_score);
    }
    if (lateness_is_late(lateness_of(gradebook, row))) {
        fputs("This was ", report);
        lateness_write(report, gradebook, row);
        fputs(". ", report);
    }
    fputs("What follows is the grader's report.</p>\n", report);
    if (corrections_has(gradebook, row)) {
        fputs("<div class=\"card\"><table><thead><tr><th>Change</th><th>Comment</th>"
              "<th>More time until</th></tr></thead><tbody>\n",
              report);
        class_correction_rows_write(report, gradebook, row);
        fputs("</tbody></table></div>\n", report);
    }
    fputs("</section>\n", report);
}

// Write a report's head with the score that counts in the place of the grader's.
//   end   of the head
static void head_write(FILE *stream, const char *report, const char *end,
                       const Gradebook *gradebook, const Row *row)
{
    static const char before[] = "<p class=\"score number\">", after[] = "<p class=\"soft\">";
    const char *score = strstr(report, before);
    const char *rest = score != NULL ? strstr(score, after) : NULL;
    if (rest != NULL && rest < end) {
        fwrite(report, 1, (size_t)(score - report), stream);
        fprintf(stream, "%s%d <small>of %d points</small></p></div>\n", before, row->score,
                gradebook->max_score);
        html_score_bar(stream, row->score, gradebook->max_score);
        report = rest;
    }
    fwrite(report, 1, (size_t)(end - report), stream);
}

char *feedback_report(const Gradebook *gradebook, const Row *row, size_t *n_bytes)
{
    char path[PATH_MAX];
    feedback_report_path(gradebook, row, path);
    char *report = text_file_read(path);
    if (report == NULL) {
        return NULL;
    }
    *n_bytes = strlen(report);
    // Names and messages are escaped in a report: the first such mark is the grader's own.
    static const char head_end[] = "</header>\n";
    const char *rest = strstr(report, head_end);
    const int is_changed =
        corrections_has(gradebook, row) || lateness_is_late(lateness_of(gradebook, row));
    if (!is_changed || rest == NULL) {
        return report;
    }
    rest += sizeof head_end - 1;
    char *corrected = NULL;
    FILE *stream = open_memstream(&corrected, n_bytes);
    if (stream != NULL) {
        head_write(stream, report, rest, gradebook, row);
        changes_section_write(stream, gradebook, row);
        fputs(rest, stream);
        fclose(stream);
    }
    free(report);
    if (corrected == NULL) {
        complain("gradebook: %s: out of memory", path);
    }
    return corrected;
}
