// What the class has in common: distribution, failures, tasks, checks, leaderboard, pictures (see
// class_page.h).
#include "class_page.h"
#include "template.h"

#include <string.h>

// ---- Distribution ----------------------------------------------------------------------------

// Ten bars of equal width, and full marks in one of their own.
enum { N_BARS = 11, BAR_PITCH = 60, BAR_WIDTH = 48, BARS_HEIGHT = 120 };

static int bar_of(const Gradebook *gradebook, int score)
{
    return score * (N_BARS - 1) / gradebook->max_score;
}

static void bar_label_make(const Gradebook *gradebook, int bar, char label[32])
{
    const int tenth = gradebook->max_score / (N_BARS - 1);
    if (bar == N_BARS - 1) {
        snprintf(label, 32, "%d", gradebook->max_score);
    } else if (tenth * (N_BARS - 1) == gradebook->max_score && tenth > 1) {
        snprintf(label, 32, "%d&ndash;%d", bar * tenth, (bar + 1) * tenth - 1);
    } else {
        snprintf(label, 32, "%d%%", 10 * bar);
    }
}

json_t *class_bars(const Gradebook *gradebook)
{
    int counts[N_BARS] = {0};
    int most = 4;  // so that one in a class of three is no tower
    json_t *bars = json_array();
    if (gradebook->n_graded == 0 || gradebook->max_score == 0) {
        return bars;
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row_is_counted(gradebook, row)) {
            const int count = ++counts[bar_of(gradebook, row->score)];
            most = count > most ? count : most;
        }
    }
    for (int i = 0; i < N_BARS; i++) {
        const int height = counts[i] * BARS_HEIGHT / most;
        const int shown = height > 2 ? height : 2;
        const int middle = i * BAR_PITCH + BAR_PITCH / 2;
        const char *level = counts[i] == 0    ? "none"
                            : i == N_BARS - 1 ? "full"
                            : i >= N_BARS / 2 ? "some"
                                              : "few";
        char label[32];
        bar_label_make(gradebook, i, label);
        json_array_append_new(
            bars, json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:o*, s:s}", "level", level, "x",
                            middle - BAR_WIDTH / 2, "y", BARS_HEIGHT + 20 - shown, "height", shown,
                            "middle", middle, "above", BARS_HEIGHT + 14 - height, "count",
                            counts[i] > 0 ? json_integer(counts[i]) : NULL, "label", label));
    }
    return bars;
}

// ---- Look-alikes -----------------------------------------------------------------------------

json_t *class_look_alikes(const LookAlikes *look_alikes)
{
    json_t *groups = json_array();
    for (int i = 0; i < look_alikes->n_groups; i++) {
        const LookAlike *group = &look_alikes->groups[i];
        json_t *rows = json_array();
        for (int r = 0; r < group->n_rows; r++) {
            const Row *row = group->rows[r];
            json_t *json = class_row(row);
            if (strcmp(row->entrant->name, row->entrant->entry) != 0) {
                json_object_set_new(json, "entry", template_line(row->entrant->entry));
            }
            if (row_is_graded(row)) {
                json_object_set_new(json, "score", json_integer(row->score));
            }
            json_array_append_new(rows, json);
        }
        json_array_append_new(groups, json_pack("{s:o}", "rows", rows));
    }
    json_t *section = look_alikes->n_groups > 0 ? json_pack("{s:O}", "alike", groups) : json_null();
    json_decref(groups);
    return section;
}

// ---- What went wrong -------------------------------------------------------------------------

// The names of a larger group are folded away.
enum { MOST_NAMES = 24 };

// What a stage said quotes the student, and what is hidden is not for students: neither is on the
// page without names.
const char *class_failure_words(const Failure *failure, int has_names)
{
    const int is_ours =
        has_names || (failure->check >= 0 && !failure->rows[0]->is_hidden[failure->check]);
    const char *words = failure->cause != NULL ? failure->cause : failure->sentence;
    return is_ours ? words : "";
}

static json_t *failure_of(const Failure *failure, int has_names)
{
    const Row *shown = has_names ? failure->shown : NULL;
    json_t *rows = json_array();
    for (int i = 0; i < failure->n_rows; i++) {
        json_array_append_new(rows, class_row(failure->rows[i]));
    }
    return json_pack("{s:b, s:i, s:o, s:s, s:o, s:s*, s:s*, s:o}", "is_open",
                     failure->n_rows <= MOST_NAMES, "n", failure->n_rows, "title",
                     template_line(failure->title), "id", failure->id, "words",
                     template_line(class_failure_words(failure, has_names)), "slug",
                     shown != NULL ? shown->entrant->slug : NULL, "picture",
                     shown != NULL ? shown->picture : NULL, "rows", rows);
}

json_t *class_failures(const Gradebook *gradebook, const Failures *failures)
{
    int n_nothing = 0, n_common = 0;
    if (failures->n_failures == 0 && gradebook->n_nothing == 0) {
        return json_null();
    }
    // Who handed in nothing of this lab, as one group: also where nobody has names.
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        n_nothing += row->status == ROW_NOTHING && row_that_counts(gradebook, row) == row;
    }
    while (n_common < failures->n_failures && failures->failures[n_common].n_rows > 1) {
        n_common++;
    }
    // What happened to one only is folded away where others have something in common.
    const int n_single = failures->n_failures - n_common;
    const int is_folded = n_common > 0 && n_single > 3;
    json_t *groups = json_array();
    for (int i = 0; i < failures->n_failures; i++) {
        json_t *group = failure_of(&failures->failures[i], !gradebook->has_no_names);
        if (is_folded && i == n_common) {
            json_object_set_new(group, "n_folded", json_integer(n_single));
        }
        json_array_append_new(groups, group);
    }
    return json_pack("{s:o*, s:o, s:b}", "n_nothing",
                     n_nothing > 0 ? json_integer(n_nothing) : NULL, "groups", groups, "is_folded",
                     is_folded);
}

// ---- Tasks and checks ------------------------------------------------------------------------

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

static json_t *task_of(const Gradebook *gradebook, int t)
{
    const Column *task = &gradebook->tasks[t];
    int n_answered = 0, n_full = 0;
    double sum = 0;
    char mean[32];
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row_is_counted(gradebook, row)) {
            n_answered += is_answered(gradebook, row, task);
            n_full += row->points[t] == task->max_points;
            sum += row->points[t];
        }
    }
    snprintf(mean, sizeof mean, "%.1f", n_answered > 0 ? sum / n_answered : 0.0);
    return json_pack("{s:i, s:o, s:s, s:i, s:i, s:s, s:i}", "number", t + 1, "title",
                     template_line(task->title), "id", task->id, "n_answered", n_answered, "n_full",
                     n_full, "mean", mean, "most", task->max_points);
}

json_t *class_tasks(const Gradebook *gradebook)
{
    json_t *tasks = json_array();
    for (int t = 0; t < gradebook->n_tasks; t++) {
        json_array_append_new(tasks, task_of(gradebook, t));
    }
    return tasks;
}

json_t *class_checks(const Gradebook *gradebook)
{
    json_t *checks = json_array();
    for (int i = 0; i < gradebook->n_checks; i++) {
        int n_passed = 0, n_counted = 0;
        for (int r = 0; r < gradebook->n_rows; r++) {
            const Row *row = &gradebook->rows[r];
            const int counts = row_is_counted(gradebook, row);
            n_counted += counts;
            n_passed += counts && row->passed[i];
        }
        json_array_append_new(checks, json_pack("{s:o, s:s, s:o, s:i, s:i}", "title",
                                                template_line(gradebook->checks[i].title), "id",
                                                gradebook->checks[i].id, "bar",
                                                template_bar(n_passed, n_counted), "n_passed",
                                                n_passed, "n_counted", n_counted));
    }
    return checks;
}

// ---- Leaderboard -----------------------------------------------------------------------------

// The page shows these; gradebook.json has all.
enum { MOST_PLACES = 20 };

json_t *class_leaderboard(const Gradebook *gradebook, const Leaderboard *leaderboard)
{
    const int n = leaderboard->n_places;
    json_t *places = json_array();
    for (int i = 0; i < n && i < MOST_PLACES; i++) {
        const Place *place = &leaderboard->places[i];
        const double own = place->row->leaderboard, best = leaderboard->places[0].row->leaderboard;
        char width[16], figure[32];
        snprintf(width, sizeof width, "%.1f", 100 * own / best);
        snprintf(figure, sizeof figure, "%.1f", own);
        json_t *json = class_row(place->row);
        json_object_update_new(json, json_pack("{s:i, s:s, s:s}", "rank", place->rank, "width",
                                               width, "figure", figure));
        json_array_append_new(places, json);
    }
    json_t *section =
        n == 0 ? json_null()
               : json_pack("{s:o, s:O, s:o*}", "counted", template_line(gradebook->leaderboard),
                           "places", places, "n_more",
                           n > MOST_PLACES ? json_integer(n - MOST_PLACES) : NULL);
    json_decref(places);
    return section;
}

// ---- Pictures --------------------------------------------------------------------------------

json_t *class_pictures(const Gradebook *gradebook)
{
    json_t *pictures = json_array();
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Row *row = &gradebook->rows[i];
        if (row->picture != NULL) {
            json_t *json = class_row(row);
            json_object_update_new(json, json_pack("{s:s, s:s, s:i}", "slug", row->entrant->slug,
                                                   "picture", row->picture, "score", row->score));
            json_array_append_new(pictures, json);
        }
    }
    return pictures;
}
