// gradebook.json: the class for programs (see gradebook.h).
//
// Written row by row. Scores are whole numbers; a row that is not entered has none. The table of a
// term is made of these files (term.h), so they say who each row counts for. Read next:
// gradebook_csv.c.
#include "class_page.h"

#include "complain.h"
#include "corrections.h"
#include "lateness.h"
#include "moment.h"
#include "output_file.h"
#include "participant_fit.h"

#include <jansson.h>

// A number, or NULL, which json_pack() leaves out as "o*".
static json_t *number_if(int is_there, int number)
{
    return is_there ? json_integer(number) : NULL;
}

static json_t *points_json(const Gradebook *gradebook, const Row *row)
{
    json_t *points = json_object();
    for (int i = 0; i < gradebook->n_tasks; i++) {
        json_object_set_new(points, gradebook->tasks[i].id, json_integer(row->points[i]));
    }
    return points;
}

// What became of the checks that did not pass.
static void checks_add(json_t *json, const Gradebook *gradebook, const Row *row)
{
    json_t *not_passed = json_array();
    json_t *not_run = json_array();
    json_t *causes = json_object();
    for (int i = 0; i < gradebook->n_checks; i++) {
        const char *id = gradebook->checks[i].id;
        if (!row->passed[i]) {
            json_array_append_new(not_passed, json_string(id));
        }
        if (row->not_run[i]) {
            json_array_append_new(not_run, json_string(id));
        }
        if (row->causes[i] != NULL) {
            json_object_set_new(causes, id, json_string(row->causes[i]));
        }
    }
    json_object_set_new(json, "not_passed", not_passed);
    json_object_set_new(json, "not_run", not_run);
    json_object_set_new(json, "causes", causes);
}

static json_t *correction_json(const Correction *correction)
{
    const int is_applied = correction->is_applied;
    return json_pack("{s:s, s:s, s:s*, s:s*, s:o*, s:o*, s:o*}", "comment", correction->comment,
                     "until", correction->until, "task", correction->task, "check",
                     correction->check, "before", number_if(is_applied, correction->before),
                     "after", number_if(is_applied, correction->after), "applied",
                     correction->has_points ? json_boolean(is_applied) : NULL);
}

// When it was handed in, where that is known, and what it cost.
static json_t *late_json(const LateRow *late)
{
    char handed_in[MOMENT_BYTES] = "";
    if (late->has_time) {
        moment_stamp(late->handed_in, handed_in);
    }
    return json_pack("{s:b, s:i, s:i, s:s*, s:o*}", "is_late", lateness_is_late(late), "seconds",
                     (int)late->seconds, "points_off", late->off, "handed_in",
                     late->has_time ? handed_in : NULL, "unknown", json_string(late->unknown));
}

static json_t *corrections_json(const Gradebook *gradebook, const Row *row)
{
    const Correction *correction = NULL;
    json_t *json = json_array();
    while ((correction = corrections_next(gradebook, row, NULL, correction)) != NULL) {
        json_array_append_new(json, correction_json(correction));
    }
    return json;
}

// Of participants who handed in nothing.
static json_t *others_json(const Corrections *corrections)
{
    json_t *json = json_array();
    for (int i = 0; i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (correction->row == NULL) {
            char name[ENTRY_NAME_BYTES];
            participant_name(corrections->worksheet, correction->participant, name);
            json_t *other = correction_json(correction);
            json_object_set_new(other, "name", json_string(name));
            json_object_set_new(
                other, "number",
                json_string(participant_number(corrections->worksheet, correction->participant)));
            json_array_append_new(json, other);
        }
    }
    return json;
}

// ---- Whose it is -----------------------------------------------------------------------------

static json_t *participant_json(const Worksheet *worksheet, const Participant *participant)
{
    char name[ENTRY_NAME_BYTES];
    participant_name(worksheet, participant, name);
    return json_pack("{s:s, s:s, s:s}", "name", name, "address",
                     participant_address(worksheet, participant), "id_number",
                     participant_sid(worksheet, participant));
}

// Who a row counts for, as far as a list or the export says it.
static json_t *owners_json(const Row *row, const Worksheet *worksheet)
{
    json_t *owners = json_array();
    for (int i = 1; worksheet != NULL && i < worksheet->n_participants; i++) {
        if (worksheet->participants[i].row == row) {
            json_array_append_new(owners, participant_json(worksheet, &worksheet->participants[i]));
        }
    }
    for (int i = 0; worksheet == NULL && i < row->entrant->n_members; i++) {
        const Member *member = &row->entrant->members[i];
        json_array_append_new(owners, json_pack("{s:s, s:s, s:s}", "name", member->name, "address",
                                                member->email, "id_number", member->sid));
    }
    return owners;
}

// Those of the list who have no row: nothing is theirs, or not for certain.
static json_t *without_json(const Worksheet *worksheet)
{
    json_t *list = json_array();
    for (int i = 1; worksheet != NULL && i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (participant->row != NULL || participant->is_nobody) {
            continue;
        }
        json_t *json = participant_json(worksheet, participant);
        json_object_set_new(json, "status",
                            json_string(participant->is_fitted ? "not entered" : "no submission"));
        json_array_append_new(list, json);
    }
    return list;
}

// ---- A row -----------------------------------------------------------------------------------

static json_t *row_json(const Gradebook *gradebook, const Row *row, const Worksheet *worksheet)
{
    const Entrant *entrant = row->entrant;
    const LateRow *late = lateness_of(gradebook, row);
    const int is_entered = row_is_entered(gradebook, row);
    char report[128];
    snprintf(report, sizeof report, "students/%s/report.html", entrant->slug);
    json_t *json = json_pack(
        "{s:s, s:s, s:s, s:i, s:s, s:s, s:b, s:o, s:o*, s:o*, s:o*, s:o*}", "id", entrant->slug,
        "name", entrant->name, "number", entrant->number, "attempt", entrant->attempt, "entry",
        entrant->entry, "status", row_status_name(row->status), "counts",
        row_that_counts(gradebook, row) == row, "owners", owners_json(row, worksheet),
        "not_entered",
        json_string(worksheet != NULL ? worksheet->entered[row - gradebook->rows].why_not : NULL),
        "reason", json_string(row->reason), "corrections",
        corrections_has(gradebook, row) ? corrections_json(gradebook, row) : NULL, "late",
        late != NULL ? late_json(late) : NULL);
    if (row->status == ROW_NOT_GRADED) {
        return json;
    }
    json_object_update_new(
        json, json_pack("{s:o*, s:o*, s:o*}", "score", number_if(is_entered, row->score),
                        "max_score", number_if(is_entered, gradebook->max_score), "score_before",
                        number_if(row->score != row->graded_score, row->graded_score)));
    if (row_is_graded(row)) {
        json_object_set_new(json, "points", points_json(gradebook, row));
        checks_add(json, gradebook, row);
    }
    json_t *fault = row->fault == NULL ? NULL
                                       : json_pack("{s:s, s:s, s:s}", "title", row->fault, "check",
                                                   row->fault_id, "message", row->fault_message);
    json_object_update_new(
        json, json_pack("{s:o*, s:o*, s:o*, s:s, s:o*}", "first_fault", fault, "leaderboard",
                        row->leaderboard != 0 ? json_real(row->leaderboard) : NULL, "seed",
                        json_string(row->seed), "report", report, "old_score",
                        number_if(row->has_old_score, row->old_score)));
    return json;
}

// Write one value and give it up. jansson hands on what went wrong while it was made: NULL fails.
static int value_write(json_t *json, FILE *file)
{
    const size_t layout = JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(6);
    const int written = json != NULL ? json_dumpf(json, file, layout) : -1;
    json_decref(json);
    return written;
}

static json_t *tasks_json(const Gradebook *gradebook)
{
    json_t *tasks = json_array();
    for (int i = 0; i < gradebook->n_tasks; i++) {
        const Column *task = &gradebook->tasks[i];
        json_array_append_new(tasks, json_pack("{s:s, s:s, s:i}", "id", task->id, "title",
                                               task->title, "max_points", task->max_points));
    }
    return tasks;
}

static json_t *checks_json(const Gradebook *gradebook)
{
    json_t *checks = json_array();
    for (int i = 0; i < gradebook->n_checks; i++) {
        const Column *check = &gradebook->checks[i];
        json_array_append_new(checks, json_pack("{s:s, s:s, s:s}", "id", check->id, "title",
                                                check->title, "task", check->task));
    }
    return checks;
}

int gradebook_json(const Gradebook *gradebook, const char *path, const Worksheet *worksheet)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    FILE *file = output.file;
    fputs("{\n\"lab\": ", file);
    int failed = value_write(gradebook->lab ? json_string(gradebook->lab) : json_null(), file);
    fputs(",\n\"title\": ", file);
    failed |= value_write(gradebook->title ? json_string(gradebook->title) : json_null(), file);
    if (gradebook->leaderboard != NULL) {
        fputs(",\n\"leaderboard\": ", file);
        failed |= value_write(json_string(gradebook->leaderboard), file);
    }
    fprintf(file, ",\n\"max_score\": %d,\n\"tasks\": ", gradebook->max_score);
    failed |= value_write(tasks_json(gradebook), file);
    fputs(",\n\"checks\": ", file);
    failed |= value_write(checks_json(gradebook), file);
    if (gradebook->corrections != NULL) {
        fputs(",\n\"without_submission\": ", file);
        failed |= value_write(others_json(gradebook->corrections), file);
    }
    fputs(",\n\"students\": [", file);
    for (int i = 0; i < gradebook->n_rows; i++) {
        fputs(i > 0 ? ",\n" : "\n", file);
        failed |= value_write(row_json(gradebook, &gradebook->rows[i], worksheet), file);
    }
    fputs("\n],\n\"without\": ", file);
    failed |= value_write(without_json(worksheet), file);
    fputs("\n}\n", file);
    if (failed) {
        output_file_discard(&output);
        complain("gradebook: %s: cannot write", path);
        return -1;
    }
    return output_file_commit(&output);
}
