// What the class has in common: distribution, changes, failures, checks, leaderboard, pictures (see
// class_page.h).
#include "class_page.h"

#include "corrections.h"
#include "html.h"

#include <string.h>

// ---- Distribution ----------------------------------------------------------------------------

// Ten bars of equal width, and full marks in one of their own.
enum { N_BARS = 11, BAR_PITCH = 60, BAR_WIDTH = 48, BARS_HEIGHT = 120 };

static int bar_of(const Gradebook *gradebook, int score)
{
    return score * (N_BARS - 1) / gradebook->max_score;
}

static void bar_label_write(FILE *page, const Gradebook *gradebook, int bar)
{
    const int tenth = gradebook->max_score / (N_BARS - 1);
    if (bar == N_BARS - 1) {
        fprintf(page, "%d", gradebook->max_score);
    } else if (tenth * (N_BARS - 1) == gradebook->max_score && tenth > 1) {
        fprintf(page, "%d&ndash;%d", bar * tenth, (bar + 1) * tenth - 1);
    } else {
        fprintf(page, "%d%%", 10 * bar);
    }
}

void class_histogram_write(FILE *page, const Gradebook *gradebook)
{
    int counts[N_BARS] = {0};
    int most = 4;  // so that one in a class of three is no tower
    if (gradebook->n_graded == 0 || gradebook->max_score == 0) {
        return;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (row_is_graded(&gradebook->rows[i])) {
            const int count = ++counts[bar_of(gradebook, gradebook->rows[i].score)];
            most = count > most ? count : most;
        }
    }
    fprintf(page,
            "<figure class=\"card histogram\"><svg viewBox=\"0 0 %d %d\" role=\"img\" "
            "aria-label=\"How many submissions have which score\">\n",
            N_BARS * BAR_PITCH, BARS_HEIGHT + 44);
    for (int i = 0; i < N_BARS; i++) {
        const int height = counts[i] * BARS_HEIGHT / most;
        const int middle = i * BAR_PITCH + BAR_PITCH / 2;
        const char *level = counts[i] == 0    ? "none"
                            : i == N_BARS - 1 ? "full"
                            : i >= N_BARS / 2 ? "some"
                                              : "few";
        char count[16] = "";
        if (counts[i] > 0) {
            snprintf(count, sizeof count, "%d", counts[i]);
        }
        fprintf(page,
                "<rect class=\"%s\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"3\"/>"
                "<text x=\"%d\" y=\"%d\">%s</text><text class=\"soft\" x=\"%d\" y=\"%d\">",
                level, middle - BAR_WIDTH / 2, BARS_HEIGHT + 20 - (height > 2 ? height : 2),
                BAR_WIDTH, height > 2 ? height : 2, middle, BARS_HEIGHT + 14 - height, count,
                middle, BARS_HEIGHT + 38);
        bar_label_write(page, gradebook, i);
        fputs("</text>\n", page);
    }
    fputs("</svg></figure>\n", page);
}

// ---- Look-alikes -----------------------------------------------------------------------------

void class_look_alikes_write(FILE *page, const LookAlikes *look_alikes)
{
    if (look_alikes->n_groups == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"look-alikes\">Perhaps one person</h2>\n"
          "<p class=\"soft\">These names look alike, but nothing that a host wrote says whose they "
          "are: each keeps its own row, and which one counts is yours to decide.</p>\n"
          "<div class=\"card\">\n",
          page);
    for (int i = 0; i < look_alikes->n_groups; i++) {
        const LookAlike *group = &look_alikes->groups[i];
        fputs("<p class=\"failure\">", page);
        for (int r = 0; r < group->n_rows; r++) {
            const Row *row = group->rows[r];
            fputs(r > 0 ? " &middot; " : "", page);
            class_name_write(page, row);
            if (strcmp(row->entrant->name, row->entrant->entry) != 0) {
                fputs(" <code class=\"soft\">", page);
                html_line(page, row->entrant->entry);
                fputs("</code>", page);
            }
            if (row_is_graded(row)) {
                fprintf(page, " <b class=\"number\">%d</b>", row->score);
            }
        }
        fputs("</p>\n", page);
    }
    fputs("</div>\n", page);
}

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

// ---- The same failure ------------------------------------------------------------------------

// The names of a larger group are folded away.
enum { MOST_NAMES = 24 };

static void failure_write(FILE *page, const Failure *failure)
{
    fprintf(page, "<details class=\"failure\"%s><summary><span class=\"number\">%d</span><span><b>",
            failure->n_rows <= MOST_NAMES ? " open" : "", failure->n_rows);
    html_line(page, failure->first->fault);
    fputs("</b> <code class=\"soft\">", page);
    html_line(page, failure->first->fault_id);
    fputs("</code><span class=\"message\">", page);
    html_line(page, failure->first->fault_message);
    fputs("</span></span></summary>\n<p class=\"names\">", page);
    for (int i = 0; i < failure->n_rows; i++) {
        fputs(i > 0 ? " &middot; " : "", page);
        class_name_write(page, failure->rows[i]);
    }
    fputs("</p></details>\n", page);
}

void class_failures_write(FILE *page, const Failures *failures)
{
    if (failures->n_failures == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"failures\">What went wrong first</h2>\n"
          "<p class=\"soft\">Submissions whose first fault is the same, numbers aside.</p>\n"
          "<div class=\"card\">\n",
          page);
    for (int i = 0; i < failures->n_failures; i++) {
        failure_write(page, &failures->failures[i]);
    }
    fputs("</div>\n", page);
}

// ---- Checks ----------------------------------------------------------------------------------

void class_checks_write(FILE *page, const Gradebook *gradebook)
{
    if (gradebook->n_checks == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"checks\">How many passed each check</h2>\n"
          "<div class=\"card\">\n",
          page);
    for (int i = 0; i < gradebook->n_checks; i++) {
        int n_passed = 0;
        for (int r = 0; r < gradebook->n_rows; r++) {
            n_passed += gradebook->rows[r].passed[i];
        }
        fputs("<div class=\"count\"><div>", page);
        html_line(page, gradebook->checks[i].title);
        fputs(" <code class=\"soft\">", page);
        html_line(page, gradebook->checks[i].id);
        fputs("</code></div>", page);
        html_score_bar(page, n_passed, gradebook->n_graded);
        fprintf(page, "<span class=\"number\">%d of %d</span></div>\n", n_passed,
                gradebook->n_graded);
    }
    fputs("</div>\n", page);
}

// ---- Leaderboard -----------------------------------------------------------------------------

// The page shows these; gradebook.json has all.
enum { MOST_PLACES = 20 };

static void place_write(FILE *page, const Place *place, double best)
{
    fprintf(page, "<div class=\"count\"><div><span class=\"rank number\">%d.</span> ", place->rank);
    class_name_write(page, place->row);
    fprintf(page,
            "</div><div class=\"bar speed\"><div style=\"width: %.1f%%\"></div></div>"
            "<span class=\"number\">%.1f</span></div>\n",
            100 * place->row->leaderboard / best, place->row->leaderboard);
}

void class_leaderboard_write(FILE *page, const Gradebook *gradebook, const Leaderboard *leaderboard)
{
    const int n = leaderboard->n_places;
    if (n == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"leaderboard\">Leaderboard</h2>\n<p class=\"soft\">How many ",
          page);
    html_line(page, gradebook->leaderboard);
    fputs(", of those who have every point. Measured while grading, once each: what else the "
          "machine did has changed it, and a submission can forge it. It is for fun, and gives and "
          "costs no points.</p>\n<div class=\"card\">\n",
          page);
    for (int i = 0; i < n && i < MOST_PLACES; i++) {
        place_write(page, &leaderboard->places[i], leaderboard->places[0].row->leaderboard);
    }
    if (n > MOST_PLACES) {
        fprintf(page, "<div class=\"count\"><div class=\"soft\">and %d more</div></div>\n",
                n - MOST_PLACES);
    }
    fputs("</div>\n", page);
}

// ---- Pictures --------------------------------------------------------------------------------

void class_gallery_write(FILE *page, const Gradebook *gradebook)
{
    int n_pictures = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        n_pictures += gradebook->rows[i].picture != NULL;
    }
    if (n_pictures == 0) {
        return;
    }
    fputs("<h2 class=\"section\" id=\"gallery\">Every picture</h2>\n<div class=\"gallery\">\n",
          page);
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->picture == NULL) {
            continue;
        }
        fprintf(page,
                "<figure><a href=\"students/%s/report.html\"><img loading=\"lazy\" alt=\"picture\" "
                "src=\"students/%s/%s\"></a><figcaption>",
                row->entrant->slug, row->entrant->slug, row->picture);
        class_name_write(page, row);
        fprintf(page, " <span class=\"number\">%d</span></figcaption></figure>\n", row->score);
    }
    fputs("</div>\n", page);
}
