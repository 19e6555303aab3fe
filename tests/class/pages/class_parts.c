// What the class has in common: distribution, changes, failures, checks, leaderboard, pictures (see
// class_page.h).
#include "class_page.h"

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
        const Row *row = &gradebook->rows[i];
        if (row_is_counted(gradebook, row)) {
            const int count = ++counts[bar_of(gradebook, row->score)];
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

// ---- What went wrong -------------------------------------------------------------------------

// The names of a larger group are folded away.
enum { MOST_NAMES = 24 };

static void names_write(FILE *page, const Row *const *rows, int n_rows)
{
    fputs("<p class=\"names\">", page);
    for (int i = 0; i < n_rows; i++) {
        fputs(i > 0 ? " &middot; " : "", page);
        class_name_write(page, rows[i]);
    }
    fputs("</p>\n", page);
}

static void failure_picture_write(FILE *page, const Row *row)
{
    fprintf(page,
            "<figure><a href=\"students/%s/report.html\"><img loading=\"lazy\" alt=\"one of the "
            "pictures\" src=\"students/%s/%s\"></a></figure>\n",
            row->entrant->slug, row->entrant->slug, row->picture);
}

// What a stage said quotes the student, and what is hidden is not for students: neither is on the
// page without names.
const char *class_failure_words(const Failure *failure, int has_names)
{
    const int is_ours =
        has_names || (failure->check >= 0 && !failure->rows[0]->is_hidden[failure->check]);
    const char *words = failure->cause != NULL ? failure->cause : failure->sentence;
    return is_ours ? words : "";
}

static void failure_write(FILE *page, const Failure *failure, int has_names)
{
    fprintf(page, "<details class=\"failure\"%s><summary><span class=\"number\">%d</span><span><b>",
            failure->n_rows <= MOST_NAMES ? " open" : "", failure->n_rows);
    html_line(page, failure->title);
    fputs("</b> <code class=\"soft\">", page);
    html_line(page, failure->id);
    fputs("</code><span class=\"message\">", page);
    html_line(page, class_failure_words(failure, has_names));
    fputs("</span></span></summary>\n", page);
    if (has_names && failure->shown != NULL) {
        failure_picture_write(page, failure->shown);
    }
    names_write(page, failure->rows, failure->n_rows);
    fputs("</details>\n", page);
}

// Who handed in nothing of this lab, as one group: also where nobody has names.
static void nothing_group_write(FILE *page, const Gradebook *gradebook)
{
    int n = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n += row->status == ROW_NOTHING && row_that_counts(gradebook, row) == row;
    }
    if (n > 0) {
        fprintf(page,
                "<div class=\"failure\"><div class=\"plain\"><span class=\"number\">%d</span>"
                "<span><b>Nothing of this lab was handed in</b></span></div></div>\n",
                n);
    }
}

void class_failures_write(FILE *page, const Gradebook *gradebook, const Failures *failures)
{
    const int has_names = !gradebook->has_no_names;
    int n = 0;
    if (failures->n_failures == 0 && gradebook->n_nothing == 0) {
        return;
    }
    fputs(
        "<h2 class=\"section\" id=\"failures\">What went wrong</h2>\n"
        "<p class=\"soft\">Every fault of everybody who counts, by its cause where that is known, "
        "numbers aside. A task that was not answered is no fault.</p>\n"
        "<div class=\"card\">\n",
        page);
    nothing_group_write(page, gradebook);
    for (; n < failures->n_failures && failures->failures[n].n_rows > 1; n++) {
        failure_write(page, &failures->failures[n], has_names);
    }
    // What happened to one only is folded away where others have something in common.
    const int n_single = failures->n_failures - n, is_folded = n > 0 && n_single > 3;
    if (is_folded) {
        fprintf(page,
                "<details class=\"more\"><summary>%d more, of one submission each</summary>\n",
                n_single);
    }
    for (; n < failures->n_failures; n++) {
        failure_write(page, &failures->failures[n], has_names);
    }
    fputs(is_folded ? "</details>\n</div>\n" : "</div>\n", page);
}

// ---- Tasks -----------------------------------------------------------------------------------

// A check of the task that the row's result calls open: then the whole task is.
static int is_answered(const Gradebook *gradebook, const Row *row, const Column *task)
{
    for (int i = 0; i < gradebook->n_checks; i++) {
        if (strcmp(gradebook->checks[i].task, task->id) == 0 && row->is_open[i]) {
            return 0;
        }
    }
    return 1;
}

static void task_write(FILE *page, const Gradebook *gradebook, int t)
{
    const Column *task = &gradebook->tasks[t];
    int n_answered = 0, n_full = 0;
    double sum = 0;
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (!row_is_counted(gradebook, row)) {
            continue;
        }
        n_answered += is_answered(gradebook, row, task);
        n_full += row->points[t] == task->max_points;
        sum += row->points[t];
    }
    fprintf(page, "<tr><td class=\"name\">%d. ", t + 1);
    html_line(page, task->title);
    fputs(" <code class=\"soft\">", page);
    html_line(page, task->id);
    fprintf(page,
            "</code></td><td class=\"number\">%d</td><td class=\"number\">%d</td>"
            "<td class=\"number\">%.1f of %d</td></tr>\n",
            n_answered, n_full, n_answered > 0 ? sum / n_answered : 0.0, task->max_points);
}

void class_tasks_write(FILE *page, const Gradebook *gradebook)
{
    if (gradebook->n_tasks == 0) {
        return;
    }
    fputs(
        "<h2 class=\"section\" id=\"tasks\">Tasks</h2>\n<p class=\"soft\">In the order of the lab: "
        "how many handed in an answer, and what it earned.</p>\n<div class=\"card\"><table><thead>"
        "<tr><th>Task</th><th class=\"number\">Answered</th><th class=\"number\">All points</th>"
        "<th class=\"number\">Mean of the answered</th></tr></thead><tbody>\n",
        page);
    for (int t = 0; t < gradebook->n_tasks; t++) {
        task_write(page, gradebook, t);
    }
    fputs("</tbody></table></div>\n", page);
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
        int n_passed = 0, n_counted = 0;
        for (int r = 0; r < gradebook->n_rows; r++) {
            const Row *row = &gradebook->rows[r];
            const int counts = row_is_counted(gradebook, row);
            n_counted += counts;
            n_passed += counts && row->passed[i];
        }
        fputs("<div class=\"count\"><div>", page);
        html_line(page, gradebook->checks[i].title);
        fputs(" <code class=\"soft\">", page);
        html_line(page, gradebook->checks[i].id);
        fputs("</code></div>", page);
        html_score_bar(page, n_passed, n_counted);
        fprintf(page, "<span class=\"number\">%d of %d</span></div>\n", n_passed, n_counted);
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
