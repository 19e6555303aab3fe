// Gathering a class (see gradebook.h).
//
// Read next: graded.h.
#include "gradebook.h"

#include "clean_text.h"
#include "complain.h"
#include "path.h"
#include "sheet.h"
#include "text_file.h"

#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { KEY_LINE_BYTES = 256 };

const char *row_status_name(RowStatus status)
{
    static const char *const names[] = {[ROW_GRADED] = "graded",
                                        [ROW_OUTDATED] = "outdated",
                                        [ROW_NOTHING] = "nothing of this lab",
                                        [ROW_NOT_GRADED] = "not graded"};
    return names[status];
}

static int is_next_attempt(const Row *row, const Row *next)
{
    return row->entrant->attempt + 1 == next->entrant->attempt &&
           strcmp(row->entrant->name, next->entrant->name) == 0 &&
           strcmp(row->entrant->number, next->entrant->number) == 0;
}

const Row *row_that_counts(const Gradebook *gradebook, const Row *row)
{
    const Row *end = gradebook->rows + gradebook->n_rows;
    while (row > gradebook->rows && is_next_attempt(row - 1, row)) {
        row--;
    }
    const Row *counts = row;
    for (; row + 1 < end && is_next_attempt(row, row + 1); row++) {
        if (row[1].status != ROW_NOTHING || counts->status == ROW_NOTHING) {
            counts = row + 1;
        }
    }
    return counts;
}

const Row *row_versions(const Gradebook *gradebook, const Row *row, int *n)
{
    const Row *end = gradebook->rows + gradebook->n_rows;
    const Row *first = row - (row->entrant->version > 0 ? row->entrant->version - 1 : 0);
    *n = 1;
    while (first->entrant->version > 0 && first + *n < end &&
           first[*n].entrant->version == *n + 1) {
        ++*n;
    }
    return first;
}

int row_is_graded(const Row *row)
{
    return row->status == ROW_GRADED || row->status == ROW_OUTDATED;
}

int row_is_counted(const Gradebook *gradebook, const Row *row)
{
    return row_is_graded(row) && row_that_counts(gradebook, row) == row;
}

int row_is_entered(const Gradebook *gradebook, const Row *row)
{
    return (row_is_graded(row) && row->time_unknown == NULL) ||
           (row->status == ROW_NOTHING && gradebook->nothing_is_zero);
}

// ---- One row ---------------------------------------------------------------------------------

// The first line of a small file, without its newline; "" when there is none.
static void line_read(const char *path, char line[KEY_LINE_BYTES])
{
    FILE *file = fopen(path, "r");
    if (file == NULL || fgets(line, KEY_LINE_BYTES, file) == NULL) {
        line[0] = '\0';
    }
    line[strcspn(line, "\n")] = '\0';
    if (file != NULL) {
        fclose(file);
    }
}

// The line that says it: of a compiler's log the first with an error, else the first.
static char *first_line(const char *message)
{
    const char *error = strstr(message, "error:");
    while (error != NULL && error > message && error[-1] != '\n') {
        error--;
    }
    message = error != NULL ? error : message;
    char *line = strndup(message, strcspn(message, "\n"));
    char *clean = line_clean(line);
    free(line);
    return clean;
}

void row_fault_find(const Gradebook *gradebook, Row *row)
{
    row->fault = row->fault_id = row->fault_message = NULL;
    row->is_fault_hidden = 0;
    if (row->score >= gradebook->max_score) {
        return;
    }
    if (row->stage != NULL) {
        row->fault = row->stage, row->fault_id = "", row->fault_message = row->stage_said;
        return;
    }
    for (int i = 0; i < gradebook->n_checks && row->fault == NULL; i++) {
        const Column *check = &gradebook->checks[i];
        if (row->said[i] != NULL && !row->is_made_up[i]) {
            row->fault = check->title, row->fault_id = check->id;
            row->fault_message = row->said[i];
            row->is_fault_hidden = row->is_hidden[i];
        }
    }
}

static void columns_take(Gradebook *gradebook, Graded *graded)
{
    const Graded *first = &gradebook->first;
    gradebook->first = *graded;
    *graded = (Graded){0};
    gradebook->lab = first->lab, gradebook->title = first->title;
    gradebook->max_score = first->max_score;
    gradebook->tasks = first->tasks, gradebook->n_tasks = first->n_tasks;
    gradebook->checks = first->checks, gradebook->n_checks = first->n_checks;
}

static int has_columns(const Gradebook *gradebook, const Graded *graded)
{
    int same = strcmp(gradebook->lab, graded->lab) == 0 && gradebook->n_tasks == graded->n_tasks &&
               gradebook->n_checks == graded->n_checks;
    for (int i = 0; same && i < graded->n_tasks; i++) {
        same = strcmp(gradebook->tasks[i].id, graded->tasks[i].id) == 0 &&
               gradebook->tasks[i].max_points == graded->tasks[i].max_points;
    }
    for (int i = 0; same && i < graded->n_checks; i++) {
        same = strcmp(gradebook->checks[i].id, graded->checks[i].id) == 0;
    }
    return same;
}

static const char *picture_find(const char *folder, const char *slug)
{
    static const char *const names[] = {"picture.png", "picture.svg"};
    char path[PATH_MAX];
    for (int i = 0; i < 2; i++) {
        path_make(path, "%s/students/%s/%s", folder, slug, names[i]);
        if (access(path, R_OK) == 0) {
            return names[i];
        }
    }
    return NULL;
}

static int is_silent(const Column *check, Silence silence)
{
    return check->silent != NULL && strcmp(check->silent, silence_name(silence)) == 0;
}

// Take what a row needs of a result that was read.
static void row_take(Gradebook *gradebook, Graded *own, Row *row)
{
    const Graded *graded = gradebook->lab != NULL ? own : &gradebook->first;
    if (gradebook->lab == NULL) {
        columns_take(gradebook, own);
    }
    if (!has_columns(gradebook, graded)) {
        row->status = ROW_NOT_GRADED;
        row->reason = strdup("graded with other checks than the rest: run again with AGAIN=1");
        return;
    }
    row->seed = strdup(graded->seed);
    if (graded->has_nothing) {
        row->status = ROW_NOTHING;
        row->reason = first_line(graded->stage_message);
        gradebook->n_nothing++;
        return;
    }
    if (graded->leaderboard != 0 && gradebook->leaderboard == NULL) {
        gradebook->leaderboard = strdup(graded->leaderboard_title);
    }
    // What counts something else stands in no common list.
    if (graded->leaderboard != 0 && gradebook->leaderboard != NULL &&
        strcmp(gradebook->leaderboard, graded->leaderboard_title) == 0) {
        row->leaderboard = graded->leaderboard;
    }
    row->score = row->graded_score = graded->score;
    for (int i = 0; i < graded->n_tasks; i++) {
        row->points[i] = graded->tasks[i].points;
    }
    for (int i = 0; i < graded->n_checks; i++) {
        const Column *check = &graded->checks[i];
        row->passed[i] = check->status == CHECK_PASSED;
        row->not_run[i] = check->status == CHECK_NOT_RUN;
        row->causes[i] = check->cause != NULL ? strdup(check->cause) : NULL;
        row->check_points[i] = check->points;
        row->is_open[i] = is_silent(check, SILENCE_UNANSWERED);
        row->is_hidden[i] = (char)check->is_hidden;
        const int is_found = check->status == CHECK_FAILED && check->silent == NULL;
        row->said[i] = row->passed[i] ? NULL : first_line(check->message);
        row->found[i] = is_found ? row->said[i] : NULL;
    }
    if (graded->failed_stage != NULL) {
        row->stage = strdup(graded->failed_stage);
        row->stage_said = first_line(graded->stage_message);
    }
    row_fault_find(gradebook, row);
    row->picture = picture_find(gradebook->folder, row->entrant->slug);
    gradebook->n_graded++;
}

// Fill the row of one entrant. What is wrong with one does not keep the others from their grades.
static void row_read(Gradebook *gradebook, Row *row, const char *wanted_key)
{
    const char *slug = row->entrant->slug;
    char path[PATH_MAX], line[KEY_LINE_BYTES];
    row->status = ROW_NOT_GRADED;
    if (row->entrant->is_link) {
        row->reason = strdup("neither a folder nor an archive");
        return;
    }
    path_make(path, "%s/faults/%s", gradebook->folder, slug);
    line_read(path, line);
    if (line[0] != '\0') {
        row->reason = line_clean(line);
        path_make(path, "%s/logs/%s.txt", gradebook->folder, slug);
        row->has_log = access(path, R_OK) == 0;
        return;
    }
    path_make(path, "%s/students/%s/key", gradebook->folder, slug);
    line_read(path, line);
    if (line[0] == '\0') {
        row->reason = strdup("not reached");
        return;
    }
    Graded graded;
    path_make(path, "%s/students/%s/results.json", gradebook->folder, slug);
    if (graded_load(path, &graded) != 0) {
        row->reason = strdup("its results cannot be read: run again with ONLY=failed");
        return;
    }
    row->status = strcmp(line, wanted_key) == 0 ? ROW_GRADED : ROW_OUTDATED;
    row_take(gradebook, &graded, row);
    graded_free(&graded);
}

// ---- The class -------------------------------------------------------------------------------

// The keys stand in the roster's order, but for those that cannot be graded.
static int rows_read(Gradebook *gradebook)
{
    char path[PATH_MAX], line[KEY_LINE_BYTES], slug[KEY_LINE_BYTES] = "", key[KEY_LINE_BYTES] = "";
    path_make(path, "%s/keys", gradebook->folder);
    FILE *keys = fopen(path, "r");
    if (keys == NULL) {
        return path_fault(path, strerror(errno));
    }
    int result = 0;
    for (int i = 0; result == 0 && i < gradebook->roster.n_entrants; i++) {
        Row *row = &gradebook->rows[gradebook->n_rows++];
        row->entrant = &gradebook->roster.entrants[i];
        if (!row->entrant->is_link && (fgets(line, sizeof line, keys) == NULL ||
                                       sscanf(line, "%255s %255s", slug, key) != 2 ||
                                       strcmp(slug, row->entrant->slug) != 0)) {
            result = path_fault(path, "not the keys of this roster; start the class run again");
        } else {
            row_read(gradebook, row, key);
        }
    }
    fclose(keys);
    return result;
}

// An older gradebook, of the same lab; NULL after one message.
static json_t *old_gradebook_read(const char *against, const char *lab)
{
    json_error_t error;
    json_t *old = json_load_file(against, JSON_REJECT_DUPLICATES, &error);
    if (old == NULL) {
        path_fault(against, error.text);
        return NULL;
    }
    const char *old_lab = json_string_value(json_object_get(old, "lab"));
    char reason[256] = "";
    if (!json_is_array(json_object_get(old, "students"))) {
        snprintf(reason, sizeof reason, "no list \"students\": not a gradebook.json");
    } else if (lab != NULL && old_lab != NULL && strcmp(lab, old_lab) != 0) {
        snprintf(reason, sizeof reason, "found a gradebook of %.100s, expected one of %.100s",
                 old_lab, lab);
    }
    if (reason[0] != '\0') {
        path_fault(against, reason);
        json_decref(old);
        return NULL;
    }
    return old;
}

int gradebook_check_old(const char *against, const char *lab)
{
    json_t *old = old_gradebook_read(against, lab);
    const int result = old != NULL ? 0 : -1;
    json_decref(old);
    return result;
}

// The scores of an older gradebook, by the names of the files.
static int old_scores_read(Gradebook *gradebook, const char *against)
{
    json_t *old = old_gradebook_read(against, gradebook->lab);
    if (old == NULL) {
        return -1;
    }
    const json_int_t old_most = json_integer_value(json_object_get(old, "max_score"));
    if (gradebook->lab != NULL && old_most != 0 && old_most != gradebook->max_score) {
        json_decref(old);
        return path_fault(against, "its scores are parts of another maximum");
    }
    json_t *scores = json_object();
    json_t *student;
    size_t i;
    json_array_foreach(json_object_get(old, "students"), i, student)
    {
        const char *id = json_string_value(json_object_get(student, "id"));
        json_t *score = json_object_get(student, "score");
        if (id != NULL && json_is_integer(score)) {
            json_object_set(scores, id, score);
        }
    }
    for (int r = 0; r < gradebook->n_rows; r++) {
        Row *row = &gradebook->rows[r];
        json_t *score = json_object_get(scores, row->entrant->slug);
        row->has_old_score = score != NULL;
        row->old_score = (int)json_integer_value(score);
    }
    json_decref(scores);
    json_decref(old);
    gradebook->has_old_scores = 1;
    return 0;
}

int gradebook_load(const char *folder, const char *against, Gradebook *gradebook)
{
    char path[PATH_MAX];
    *gradebook = (Gradebook){.folder = folder};
    path_make(path, "%s/roster.json", folder);
    if (roster_load(path, &gradebook->roster) != 0) {
        return -1;
    }
    gradebook->rows = calloc((size_t)gradebook->roster.n_entrants + 1, sizeof *gradebook->rows);
    if (gradebook->rows == NULL) {
        return path_fault(folder, "out of memory");
    }
    if (rows_read(gradebook) != 0) {
        return -1;
    }
    return against != NULL ? old_scores_read(gradebook, against) : 0;
}

// Has a student of an older gradebook a field of this name?
static int old_has(const json_t *old, const char *field)
{
    size_t i;
    json_t *student;
    json_array_foreach(json_object_get(old, "students"), i, student)
    {
        if (json_object_get(student, field) != NULL) {
            return 1;
        }
    }
    return 0;
}

void gradebook_tell_forgotten(const Gradebook *gradebook)
{
    char path[PATH_MAX];
    json_error_t error;
    path_make(path, "%s/gradebook.json", gradebook->folder);
    json_t *old = json_load_file(path, 0, &error);
    if (gradebook->corrections == NULL && old_has(old, "corrections")) {
        complain("gradebook: the last run had CHANGES=, this one has none: nothing is corrected");
    }
    if (gradebook->lateness == NULL && old_has(old, "late")) {
        complain("gradebook: the last run had DUE=, this one has none: nobody is late");
    }
    json_decref(old);
}

int gradebook_manifest(const Gradebook *gradebook, const char *lab, Manifest *manifest)
{
    char own[PATH_MAX];
    path_make(own, "%s/lab.json", gradebook->folder);
    return manifest_load_file(access(own, F_OK) == 0 ? own : NULL, lab, manifest);
}

void gradebook_free(Gradebook *gradebook)
{
    for (int i = 0; i < gradebook->n_rows; i++) {
        Row *row = &gradebook->rows[i];
        free(row->reason), free(row->seed);
        free(row->stage), free(row->stage_said);
        for (int c = 0; c < RESULT_MAX_CHECKS; c++) {
            free(row->causes[c]), free(row->said[c]);
        }
    }
    free(gradebook->rows);
    graded_free(&gradebook->first);
    free(gradebook->leaderboard);
    roster_free(&gradebook->roster);
    *gradebook = (Gradebook){0};
}
