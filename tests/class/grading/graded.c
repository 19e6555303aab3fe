// Reading results.json back (see graded.h).
//
// The writer is report_json.c. Read next: gradebook.c.
#include "graded.h"

#include "complain.h"
#include "message.h"
#include "race.h"

#include <errno.h>
#include <jansson.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

// Far above what the grader writes for RESULT_MAX_CHECKS messages of the greatest length.
#define MAX_FILE_BYTES (2 * 1024 * 1024)

// The longest complaint; what it quotes from the file is shortened to fit.
enum { COMPLAINT_BYTES = 400 };

__attribute__((format(printf, 2, 3))) static int fault(const char *path, const char *format, ...)
{
    char complaint[4 * COMPLAINT_BYTES], shown[COMPLAINT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(complaint, sizeof complaint, format, arguments);
    va_end(arguments);
    complain("%s: %s", path, message_show(complaint, shown, sizeof shown));
    return -1;
}

static int status_read(const char *word, CheckStatus *status)
{
    for (CheckStatus known = CHECK_PASSED; known <= CHECK_NOT_RUN; known++) {
        if (strcmp(word, check_status_name(known)) == 0) {
            *status = known;
            return 0;
        }
    }
    return -1;
}

static int points_agree(int points, int max_points)
{
    return points >= 0 && points <= max_points && max_points <= 1000;
}

static int stages_read(const char *path, json_t *stages, Graded *graded)
{
    if (json_array_size(stages) > RESULT_MAX_STAGES) {
        return fault(path, "found more than %d stages", RESULT_MAX_STAGES);
    }
    for (size_t i = 0; i < json_array_size(stages); i++) {
        const char *title, *word, *message;
        CheckStatus status;
        json_error_t error;
        if (json_unpack_ex(json_array_get(stages, i), &error, JSON_STRICT, "{s:s, s:s, s:s}",
                           "title", &title, "status", &word, "message", &message) != 0) {
            return fault(path, "stages[%zu]: %s", i, error.text);
        }
        if (status_read(word, &status) != 0) {
            return fault(path, "stages[%zu]: found the status \"%s\"", i, word);
        }
        if (status == CHECK_FAILED && graded->failed_stage == NULL) {
            graded->failed_stage = title;
            graded->stage_message = message;
        }
    }
    return 0;
}

static int tasks_read(const char *path, json_t *tasks, Graded *graded)
{
    if (json_array_size(tasks) < 1 || json_array_size(tasks) > MANIFEST_MAX_TASKS) {
        return fault(path, "found %zu tasks, expected 1 to %d", json_array_size(tasks),
                     MANIFEST_MAX_TASKS);
    }
    for (size_t i = 0; i < json_array_size(tasks); i++) {
        Column *task = &graded->tasks[graded->n_tasks++];
        const char *file, *hint;
        json_error_t error;
        if (json_unpack_ex(json_array_get(tasks, i), &error, JSON_STRICT,
                           "{s:s, s:s, s:s, s:i, s:i, s?s}", "id", &task->id, "title", &task->title,
                           "file", &file, "points", &task->points, "max_points", &task->max_points,
                           "hint", &hint) != 0) {
            return fault(path, "tasks[%zu]: %s", i, error.text);
        }
        if (!points_agree(task->points, task->max_points)) {
            return fault(path, "tasks[%zu]: found %d of %d points", i, task->points,
                         task->max_points);
        }
    }
    return 0;
}

// Read the checks and compare their sums with what the tasks and the whole say they are.
static int checks_read(const char *path, json_t *checks, Graded *graded)
{
    if (json_array_size(checks) > RESULT_MAX_CHECKS) {
        return fault(path, "found more than %d checks", RESULT_MAX_CHECKS);
    }
    int points_left[MANIFEST_MAX_TASKS];
    for (int i = 0; i < graded->n_tasks; i++) {
        points_left[i] = graded->tasks[i].points;
    }
    for (size_t i = 0; i < json_array_size(checks); i++) {
        Column *check = &graded->checks[graded->n_checks++];
        const char *word, *hint, *found = NULL;
        int is_in_picture;
        json_error_t error;
        if (json_unpack_ex(json_array_get(checks, i), &error, JSON_STRICT,
                           "{s:s, s:s, s:s, s:i, s:i, s:s, s:s, s?s, s?b, s?s, s?s, s?s}", "id",
                           &check->id, "title", &check->title, "task", &check->task, "points",
                           &check->points, "max_points", &check->max_points, "status", &word,
                           "message", &check->message, "silent", &check->silent, "in_picture",
                           &is_in_picture, "cause", &check->cause, "hint", &hint, "found",
                           &found) != 0) {
            return fault(path, "checks[%zu]: %s", i, error.text);
        }
        check->is_hidden = found != NULL;
        check->message = found != NULL ? found : check->message;
        if (status_read(word, &check->status) != 0) {
            return fault(path, "checks[%zu]: found the status \"%s\"", i, word);
        }
        int owner = 0;
        while (owner < graded->n_tasks && strcmp(graded->tasks[owner].id, check->task) != 0) {
            owner++;
        }
        if (owner == graded->n_tasks) {
            return fault(path, "checks[%zu]: found the unknown task \"%s\"", i, check->task);
        }
        if (!points_agree(check->points, check->max_points) ||
            (check->points > 0 && check->status != CHECK_PASSED)) {
            return fault(path, "checks[%zu]: found %d of %d points, %s", i, check->points,
                         check->max_points, word);
        }
        points_left[owner] -= check->points;
    }
    for (int i = 0; i < graded->n_tasks; i++) {
        if (points_left[i] != 0) {
            return fault(path, "tasks[%d]: found %d points, but its checks add up to %d", i,
                         graded->tasks[i].points, graded->tasks[i].points - points_left[i]);
        }
    }
    return 0;
}

static int sums_check(const char *path, const Graded *graded)
{
    int points = 0;
    int max_points = 0;
    for (int i = 0; i < graded->n_tasks; i++) {
        points += graded->tasks[i].points;
        max_points += graded->tasks[i].max_points;
    }
    if (points != graded->score || max_points != graded->max_score) {
        return fault(path, "found a score of %d/%d, but the tasks add up to %d/%d", graded->score,
                     graded->max_score, points, max_points);
    }
    return 0;
}

// Read the figure, which only somebody with every point has. NULL: there is none.
static int leaderboard_read(const char *path, json_t *leaderboard, Graded *graded)
{
    json_error_t error;
    if (leaderboard == NULL) {
        return 0;
    }
    if (json_unpack_ex(leaderboard, &error, JSON_STRICT, "{s:s, s:F}", "title",
                       &graded->leaderboard_title, "value", &graded->leaderboard) != 0) {
        return fault(path, "leaderboard: %s", error.text);
    }
    if (!race_is_figure(graded->leaderboard) || graded->score != graded->max_score) {
        return fault(path, "leaderboard: found %g beside %d of %d points", graded->leaderboard,
                     graded->score, graded->max_score);
    }
    return 0;
}

static int fields_read(const char *path, Graded *graded)
{
    const char *device, *sandbox, *submission;
    double seconds;
    json_t *stages, *tasks, *checks, *leaderboard = NULL;
    json_error_t error;
    if (json_unpack_ex(graded->json, &error, JSON_STRICT,
                       "{s:s, s:s, s:i, s:i, s:s, s:s, s:s, s:s, s:F, s:o, s:o, s:o, s?b, s?o}",
                       "lab", &graded->lab, "title", &graded->title, "score", &graded->score,
                       "max_score", &graded->max_score, "seed", &graded->seed, "device", &device,
                       "sandbox", &sandbox, "submission", &submission, "seconds", &seconds,
                       "stages", &stages, "tasks", &tasks, "checks", &checks, "nothing_of_lab",
                       &graded->has_nothing, "leaderboard", &leaderboard) != 0) {
        return fault(path, "%s", error.text);
    }
    if (graded->has_nothing && graded->score != 0) {
        return fault(path, "nothing_of_lab: found it beside %d points", graded->score);
    }
    if (!json_is_array(stages) || !json_is_array(tasks) || !json_is_array(checks)) {
        return fault(path, "expected lists of stages, tasks and checks");
    }
    if (stages_read(path, stages, graded) != 0 || tasks_read(path, tasks, graded) != 0 ||
        checks_read(path, checks, graded) != 0 || sums_check(path, graded) != 0) {
        return -1;
    }
    return leaderboard_read(path, leaderboard, graded);
}

int graded_load(const char *path, Graded *graded)
{
    *graded = (Graded){0};
    struct stat status;
    if (stat(path, &status) != 0) {
        return fault(path, "cannot read: %s", strerror(errno));
    }
    // A pipe would block, and a huge file would fill the memory.
    if (!S_ISREG(status.st_mode) || status.st_size > MAX_FILE_BYTES) {
        return fault(path, "not a regular file of at most %d bytes", MAX_FILE_BYTES);
    }
    json_error_t error;
    graded->json = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (graded->json == NULL) {
        return fault(path, "line %d: %s", error.line, error.text);
    }
    if (fields_read(path, graded) != 0) {
        graded_free(graded);
        return -1;
    }
    return 0;
}

void graded_free(Graded *graded)
{
    json_decref(graded->json);
    *graded = (Graded){0};
}
