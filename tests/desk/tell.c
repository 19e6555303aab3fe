// Hints and progress (see tell.h).
#include "tell.h"

#include "holes.h"
#include "path.h"
#include "record.h"
#include "results.h"
#include "text_file.h"

#include <glob.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// ---- One hint more ----------------------------------------------------------------------------

// Hint `i` of a fault; NULL where there are fewer.
static const char *hint_at(const Task *task, const char *check, int i)
{
    return i == 0                     ? manifest_hint(task, check)
           : i <= MANIFEST_MORE_HINTS ? task->more_hints[i - 1]
                                      : NULL;
}

int tell_hint(const Manifest *lab)
{
    json_t *record = record_load();
    if (record == NULL) {
        return -1;
    }
    json_t *entry = json_object_get(record, lab->lab);
    const char *check = text_of(entry, "check");
    const Task *task = manifest_task(lab, text_of(entry, "task"));
    if (task == NULL) {
        printf(
            entry != NULL && check[0] == '\0'
                ? "Lab %.2s had every point when it was last graded: there is no hint to give.\n"
                : "A hint is for the first fault that was found: run make grade LAB=%.2s first.\n",
            lab->lab);
        json_decref(record);
        return 1;
    }
    const TaskCheck *own = manifest_check(lab, check);
    if (own != NULL && own->is_hidden) {
        printf("What check %s found is not shown, so there is no hint to give.\n", check);
        json_decref(record);
        return 1;
    }
    int n_hints = 0;
    while (hint_at(task, check, n_hints) != NULL) {
        n_hints++;
    }
    const int shown = number_of(entry, "hints");
    const int is_new = shown < n_hints;
    for (int i = 0; i <= shown && i < n_hints; i++) {
        printf("%s%d of %d  %s\n", i == 0 ? "" : "\n", i + 1, n_hints, hint_at(task, check, i));
    }
    printf("\nThese are hints for %s in %s, check %s.%s\n", task->id, task->file, check,
           is_new && shown + 1 < n_hints
               ? " Try first; the next hint says more."
               : " There are no more: look at one pixel, or ask somebody.");
    json_object_set_new(entry, "hints", json_integer(is_new ? shown + 1 : shown));
    return record_save(record);
}

// ---- Where --------------------------------------------------------------------------------------

// The first line of an answer in a file, or 1 where its markers are gone.
static int answer_line(const char *path, const char *task)
{
    char *text = text_file_read(path);
    int line = 1, n_lines = 1;
    for (const char *at = text; at != NULL && (at = strchr(at, '\n')) != NULL; at++) {
        n_lines++;
    }
    while (text != NULL && line < n_lines && !hole_has_line(text, task, line)) {
        line++;
    }
    free(text);
    return line < n_lines ? line : 1;
}

void tell_places(const Manifest *lab, const json_t *results)
{
    int n_told = 0;
    for (int i = 0; i < lab->n_tasks; i++) {
        const Task *task = &lab->tasks[i];
        const json_t *fault = results_task_fault(results, task->id);
        char path[PATH_MAX];
        path_make(path, "labs/%s/%s", lab->lab, task->file);
        if (fault != NULL && access(path, R_OK) == 0) {
            const char *says = fault_sentence(results, fault);
            printf("%s%s:%d: error: %s: %.*s\n", n_told++ == 0 ? "\n" : "", path,
                   answer_line(path, task->id), text_of(fault, "id"), (int)strcspn(says, "\n"),
                   says);
        }
    }
}

// ---- How far ------------------------------------------------------------------------------------

typedef struct Sum {
    int n_labs, n_done, points, max_points, hours, hours_left;
    char next[64], next_task[64];  // "": none
    char last_when[32];            // of the lab that was graded last
} Sum;

static int task_points(const Task *task)
{
    int points = 0;
    for (int i = 0; i < task->n_checks; i++) {
        points += task->checks[i].points;
    }
    return points;
}

static int lab_points(const Manifest *lab)
{
    int points = 0;
    for (int i = 0; i < lab->n_tasks; i++) {
        points += task_points(&lab->tasks[i]);
    }
    return points;
}

// A line of one lab. What is next is the first open task of the lab that was graded last, or else
// of the first open lab after it.
static void lab_print(const Manifest *lab, const json_t *entry, Sum *sum)
{
    const json_t *tasks = json_object_get(entry, "tasks");
    const char *open = NULL;
    int n_done = 0;
    for (int i = 0; i < lab->n_tasks; i++) {
        const Task *task = &lab->tasks[i];
        const int is_done = number_of(tasks, task->id) == task_points(task);
        n_done += is_done;
        open = open == NULL && !is_done ? task->id : open;
    }
    const int score = number_of(entry, "score"), most = lab_points(lab);
    char points[32] = "-";
    if (entry != NULL) {
        snprintf(points, sizeof points, "%d/%d", score, most);
    }
    printf("  %-28s %8s  %d of %d", lab->lab, points, n_done, lab->n_tasks);
    printf(lab->hours > 0 ? "  %4d  " : "        ", lab->hours);
    printf("%s%s\n",
           open == NULL    ? "done"
           : entry != NULL ? "next: "
                           : "",
           open != NULL && entry != NULL ? open : "");
    const char *when = text_of(entry, "when");
    const int is_later = entry != NULL && strcmp(when, sum->last_when) >= 0;
    if (is_later) {
        snprintf(sum->last_when, sizeof sum->last_when, "%s", when);
    }
    if (open != NULL && (is_later || sum->next[0] == '\0')) {
        snprintf(sum->next, sizeof sum->next, "%s", lab->lab);
        snprintf(sum->next_task, sizeof sum->next_task, "%s", open);
    } else if (open == NULL && is_later) {
        sum->next[0] = '\0';
    }
    sum->n_labs++;
    sum->n_done += open == NULL;
    sum->points += score;
    sum->max_points += most;
    sum->hours += lab->hours;
    sum->hours_left += open == NULL ? 0 : lab->hours;
}

int tell_progress(void)
{
    glob_t labs;
    Sum sum = {0};
    json_t *record = record_load();
    if (record == NULL || glob("labs/[0-9]*/lab.json", 0, NULL, &labs) != 0) {
        json_decref(record);
        return -1;
    }
    printf("  %-28s %8s  %6s  %4s\n", "lab", "points", "tasks", "hours");
    int result = 0;
    for (size_t i = 0; result == 0 && i < labs.gl_pathc; i++) {
        Manifest lab;
        char name[64];
        snprintf(name, sizeof name, "%.*s",
                 (int)(strrchr(labs.gl_pathv[i], '/') - labs.gl_pathv[i] - 5),
                 labs.gl_pathv[i] + 5);
        result = manifest_load("labs", name, &lab);
        if (result == 0) {
            lab_print(&lab, json_object_get(record, name), &sum);
            manifest_free(&lab);
        }
    }
    globfree(&labs);
    json_decref(record);
    if (result != 0) {
        return -1;
    }
    printf("\n%d of %d labs done, %d of %d points. Planned: %d hours; for what is open %d.\n",
           sum.n_done, sum.n_labs, sum.points, sum.max_points, sum.hours, sum.hours_left);
    if (sum.next[0] != '\0') {
        printf("Next: %s in labs/%s: make watch LAB=%.2s\n", sum.next_task, sum.next, sum.next);
    }
    printf("Kept in " RECORD_PATH ", which you may delete.\n");
    return 0;
}
