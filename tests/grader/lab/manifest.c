// Reading a lab's manifest, lab.json (see manifest.h).
//
// The file is the instructor's own, and a slip in it would cost a whole class points: every field
// is checked, and the message says where it stands, what was found and what was expected
// (json_place.h). Read next: stage.h.
#include "manifest.h"

#include "complain.h"
#include "json_place.h"
#include "message.h"
#include "number.h"
#include "path.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { POINTS_OF_A_LAB = 100, MOST_POINTS = 1000, MOST_SECONDS = 3600, MOST_HOURS = 40 };

static int files_read(const Place *object, Manifest *manifest)
{
    const Place list = place_field(object, "files");
    int n_files;
    if (place_list_length(&list, MANIFEST_MAX_FILES, &n_files) != 0) {
        return -1;
    }
    for (int i = 0; i < n_files; i++) {
        const Place place = place_item(&list, i);
        const char *file;
        if (place_text(&place, &file) != 0) {
            return -1;
        }
        // Staging copies by these names: none may lead out of the submission's folder.
        if (strchr(file, '/') != NULL || file[0] == '.') {
            return place_fault(&place, "found \"%s\", expected a plain file name", file);
        }
        if (manifest_file(manifest, file) >= 0) {
            return place_fault(&place, "found \"%s\" a second time", file);
        }
        manifest->files[manifest->n_files++] = file;
    }
    return 0;
}

// An id is written in comments and on command lines.
static int id_is_plain(const char *id)
{
    static const char allowed[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return id[strspn(id, allowed)] == '\0';
}

// Read the task's checks and their points.
//   is_changed   by an instructor, who may have turned checks off
static int points_read(const Place *object, int is_changed, Task *task)
{
    const int lowest = is_changed ? 0 : 1, highest = is_changed ? MOST_POINTS : POINTS_OF_A_LAB;
    const Place points = place_field(object, "points");
    if (!json_is_object(points.json)) {
        return place_fault_kind(&points, "an object: the points of each check");
    }
    const size_t found = json_object_size(points.json);
    if (found < 1 || found > MANIFEST_MAX_CHECKS) {
        return place_fault(&points, "found %zu entries, expected 1 to %d", found,
                           MANIFEST_MAX_CHECKS);
    }
    const char *id;
    json_t *value;
    json_object_foreach((json_t *)points.json, id, value)
    {
        TaskCheck *check = &task->checks[task->n_checks++];
        check->id = id;
        if (place_number_field(&points, id, lowest, highest, &check->points) != 0) {
            return -1;
        }
    }
    return 0;
}

// The number of the task's check with this id, or -1.
static int check_find(const Task *task, const char *id)
{
    int i = task->n_checks - 1;
    while (i >= 0 && strcmp(task->checks[i].id, id) != 0) {
        i--;
    }
    return i;
}

// Read the optional hints for single checks.
static int hints_read(const Place *object, Task *task)
{
    const Place hints = place_field(object, "hints");
    if (hints.json != NULL && !json_is_object(hints.json)) {
        return place_fault_kind(&hints, "an object");
    }
    const char *id;
    json_t *value;
    json_object_foreach((json_t *)hints.json, id, value)
    {
        const int i = check_find(task, id);
        if (i < 0) {
            return place_fault(&hints, "found the check \"%s\", expected one of \"points\"", id);
        }
        if (place_text_field(&hints, id, &task->checks[i].hint) != 0) {
            return -1;
        }
    }
    return 0;
}

// Read the optional hints for who asks for more.
static int more_hints_read(const Place *object, Task *task)
{
    const Place list = place_field(object, "more_hints");
    int n_hints;
    if (list.json == NULL) {
        return 0;
    }
    if (place_list_length(&list, MANIFEST_MORE_HINTS, &n_hints) != 0) {
        return -1;
    }
    if (n_hints != MANIFEST_MORE_HINTS) {
        return place_fault(&list, "found %d entries, expected %d", n_hints, MANIFEST_MORE_HINTS);
    }
    for (int i = 0; i < n_hints; i++) {
        const Place place = place_item(&list, i);
        if (place_text(&place, &task->more_hints[i]) != 0) {
            return -1;
        }
    }
    return 0;
}

// Read the next task.
static int task_read(const Place *place, Manifest *manifest)
{
    static const char *const known[] = {"id",   "file",  "title",      "points",
                                        "hint", "hints", "more_hints", NULL};
    Task *task = &manifest->tasks[manifest->n_tasks];
    if (place_fields_check(place, known) != 0 || place_text_field(place, "id", &task->id) != 0) {
        return -1;
    }
    if (!id_is_plain(task->id)) {
        return place_fault(place, "found the id \"%s\", expected letters, digits, _ and -",
                           task->id);
    }
    if (manifest_task(manifest, task->id) != NULL) {
        return place_fault(place, "found the id \"%s\" a second time", task->id);
    }
    if (place_text_field(place, "file", &task->file) != 0 ||
        place_text_field(place, "title", &task->title) != 0 ||
        points_read(place, manifest->changed != NULL, task) != 0 ||
        place_text_field(place, "hint", &task->hint) != 0 || hints_read(place, task) != 0 ||
        more_hints_read(place, task) != 0) {
        return -1;
    }
    if (manifest_file(manifest, task->file) < 0) {
        return place_fault(place, "found the file \"%s\", expected one of \"files\"", task->file);
    }
    manifest->n_tasks++;
    return 0;
}

//   total   of all points
static int tasks_read(const Place *object, int total, Manifest *manifest)
{
    const Place list = place_field(object, "tasks");
    int n_tasks;
    if (place_list_length(&list, MANIFEST_MAX_TASKS, &n_tasks) != 0) {
        return -1;
    }
    int points = 0;
    for (int i = 0; i < n_tasks; i++) {
        const Place place = place_item(&list, i);
        if (task_read(&place, manifest) != 0) {
            return -1;
        }
        for (int j = 0; j < manifest->tasks[i].n_checks; j++) {
            points += manifest->tasks[i].checks[j].points;
        }
    }
    if (points != total) {
        return place_fault(&list, "found %d points in all, expected %d", points, total);
    }
    return 0;
}

// Read optional fields: what is not there stays as it is.
static int optional_text(const Place *object, const char *field, const char **text)
{
    return json_object_get(object->json, field) == NULL ? 0 : place_text_field(object, field, text);
}

static int optional_number(const Place *object, const char *field, int highest, int *number)
{
    return json_object_get(object->json, field) == NULL
               ? 0
               : place_number_field(object, field, 1, highest, number);
}

// Read what the learner's desk wants to know, and what an optional figure counts. Its race is a
// program that is there before anything is handed in, and can hold no host files of a student's.
static int options_read(const Place *object, Manifest *manifest)
{
    const Place leaderboard = place_field(object, "leaderboard");
    const Place figure = place_field(object, "figure");
    if (leaderboard.json != NULL && manifest_has_host_files(manifest)) {
        return place_fault(&leaderboard,
                           "found one in a lab with host files, expected kernels only");
    }
    if (optional_text(object, "leaderboard", &manifest->leaderboard) != 0 ||
        optional_number(object, "hours", MOST_HOURS, &manifest->hours) != 0 ||
        optional_text(object, "look", &manifest->look) != 0 ||
        optional_text(object, "figure", &manifest->figure) != 0) {
        return -1;
    }
    return manifest->figure != NULL && manifest->look == NULL
               ? place_fault(&figure,
                             "found one without \"look\", expected the options that draw it")
               : 0;
}

// Read which checks find what is not for students.
static int hidden_read(const Place *changed, Manifest *manifest)
{
    const Place list = place_field(changed, "hidden");
    for (int i = 0; i < (int)json_array_size(list.json); i++) {
        const Place place = place_item(&list, i);
        const char *id = json_string_value(place.json);
        TaskCheck *check = (TaskCheck *)manifest_check(manifest, id != NULL ? id : "");
        if (check == NULL) {
            return place_fault(&place, "found what is no check, expected one of \"points\"");
        }
        check->is_hidden = 1;
    }
    return 0;
}

// Read what an instructor has changed, but for what is hidden. *total: of all points.
static int changed_read(const Place *changed, int *total, Manifest *manifest)
{
    static const char *const known[] = {"says", "total", "hidden", "time_limit", "seed", NULL};
    const Place seed = place_field(changed, "seed");
    *total = POINTS_OF_A_LAB;
    if (changed->json == NULL) {
        return 0;
    }
    if (place_fields_check(changed, known) != 0 ||
        place_text_field(changed, "says", &manifest->changed) != 0 ||
        place_number_field(changed, "total", 1, MOST_POINTS, total) != 0) {
        return -1;
    }
    manifest->has_seed = seed.json != NULL;
    if (seed.json != NULL &&
        (!json_is_string(seed.json) ||
         number_read_unsigned(json_string_value(seed.json), 0, UINT64_MAX, &manifest->seed) != 0)) {
        return place_fault(&seed, "found no whole number in a string");
    }
    return optional_number(changed, "time_limit", MOST_SECONDS, &manifest->time_limit);
}

static int fields_read(const Place *object, Manifest *manifest)
{
    static const char *const known[] = {"title", "files",  "tasks",   "leaderboard", "hours",
                                        "look",  "figure", "changed", NULL};
    const Place changed = place_field(object, "changed");
    int total;
    return changed_read(&changed, &total, manifest) != 0 ||
                   place_fields_check(object, known) != 0 ||
                   place_text_field(object, "title", &manifest->title) != 0 ||
                   files_read(object, manifest) != 0 || tasks_read(object, total, manifest) != 0 ||
                   hidden_read(&changed, manifest) != 0 || options_read(object, manifest) != 0
               ? -1
               : 0;
}

static int file_read(const char *path, Manifest *manifest)
{
    Place place = {.path = path};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return place_fault(&place, "cannot read: %s", strerror(errno));
    }
    json_error_t error;
    place.json = manifest->json = json_loadf(file, JSON_REJECT_DUPLICATES, &error);
    fclose(file);
    if (place.json == NULL) {
        char shown[400];
        complain("%s:%d: %s", path, error.line, message_show(error.text, shown, sizeof shown));
        return -1;
    }
    return fields_read(&place, manifest);
}

int manifest_load(const char *labs_folder, const char *lab, Manifest *manifest)
{
    *manifest = (Manifest){0};
    if (lab[0] == '\0' || lab[0] == '.' || strchr(lab, '/') != NULL ||
        strlen(lab) >= sizeof manifest->lab) {
        complain("found the lab \"%s\", expected the name of a folder in %s", lab, labs_folder);
        return -1;
    }
    char path[PATH_MAX];
    path_make(path, "%s/%s/lab.json", labs_folder, lab);
    return manifest_load_file(path, lab, manifest);
}

int manifest_load_file(const char *path, const char *lab, Manifest *manifest)
{
    if (path == NULL) {
        return manifest_load(manifest_folder(lab), lab, manifest);
    }
    *manifest = (Manifest){0};
    snprintf(manifest->lab, sizeof manifest->lab, "%s", lab);
    if (file_read(path, manifest) != 0) {
        manifest_free(manifest);
        return -1;
    }
    return 0;
}

void manifest_free(Manifest *manifest)
{
    json_decref(manifest->json);
    *manifest = (Manifest){0};
}

int manifest_file(const Manifest *manifest, const char *name)
{
    int i = manifest->n_files - 1;
    while (i >= 0 && strcmp(manifest->files[i], name) != 0) {
        i--;
    }
    return i;
}

const Task *manifest_task(const Manifest *manifest, const char *id)
{
    for (int i = 0; i < manifest->n_tasks; i++) {
        if (strcmp(manifest->tasks[i].id, id) == 0) {
            return &manifest->tasks[i];
        }
    }
    return NULL;
}

const TaskCheck *manifest_check(const Manifest *manifest, const char *id)
{
    for (int t = 0; t < manifest->n_tasks; t++) {
        const int i = check_find(&manifest->tasks[t], id);
        if (i >= 0) {
            return &manifest->tasks[t].checks[i];
        }
    }
    return NULL;
}

const char *manifest_hint(const Task *task, const char *id)
{
    const int i = check_find(task, id);
    return i >= 0 && task->checks[i].hint != NULL ? task->checks[i].hint : task->hint;
}

int manifest_has_solution(const char *lab)
{
    char path[PATH_MAX];
    path_make(path, "solutions/%s", lab);
    return access(path, F_OK) == 0;
}

const char *manifest_folder(const char *lab)
{
    return manifest_has_solution(lab) ? "solutions" : "labs";
}

static int ends_with(const char *name, const char *ending)
{
    const char *last = strrchr(name, '.');
    return last != NULL && strcmp(last, ending) == 0;
}

static int has_file(const Manifest *manifest, const char *ending)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (ends_with(manifest->files[i], ending)) {
            return 1;
        }
    }
    return 0;
}

int manifest_is_host_file(const char *name)
{
    return ends_with(name, ".c");
}

int manifest_has_host_files(const Manifest *manifest)
{
    return has_file(manifest, ".c");
}

int manifest_has_kernels(const Manifest *manifest)
{
    return has_file(manifest, ".cl");
}
