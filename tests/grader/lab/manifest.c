// Reading a lab's manifest, lab.json (see manifest.h).
//
// The file is the instructor's own, and a slip in it would cost a whole class points: every field
// is checked, and the message says where it stands, what was found and what was expected. That is
// why json_unpack_ex() of jansson does not read them: its errors leave out the place, "tasks[2]".
// Read next: stage.h.
#include "manifest.h"

#include "complain.h"
#include "message.h"
#include "path.h"

#include <errno.h>
#include <jansson.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { POINTS_OF_A_LAB = 100 };

// A value in the file, with the words for saying where it stands.
typedef struct Place {
    const char *path;    // of the file
    char name[80];       // "tasks[2].points"; "" for the file's one object
    const json_t *json;  // NULL when it is missing
} Place;

// The longest complaint; what it quotes from the file is shortened to fit.
enum { COMPLAINT_BYTES = 400 };

__attribute__((format(printf, 2, 3))) static int fault(const Place *place, const char *format, ...)
{
    char complaint[4 * COMPLAINT_BYTES], shown[COMPLAINT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(complaint, sizeof complaint, format, arguments);
    va_end(arguments);
    complain("%s: %s%s%s", place->path, place->name, place->name[0] != '\0' ? ": " : "",
             message_show(complaint, shown, sizeof shown));
    return -1;
}

static int fault_kind(const Place *place, const char *expected)
{
    static const char *const kinds[] = {
        [JSON_OBJECT] = "an object", [JSON_ARRAY] = "a list",    [JSON_STRING] = "a string",
        [JSON_INTEGER] = "a number", [JSON_REAL] = "a fraction", [JSON_TRUE] = "true",
        [JSON_FALSE] = "false",      [JSON_NULL] = "null",
    };
    const char *found = place->json == NULL ? "nothing" : kinds[json_typeof(place->json)];
    return fault(place, "found %s, expected %s", found, expected);
}

static Place place_field(const Place *object, const char *field)
{
    Place place = {.path = object->path, .json = json_object_get(object->json, field)};
    snprintf(place.name, sizeof place.name, "%.60s%s%.16s", object->name,
             object->name[0] != '\0' ? "." : "", field);
    return place;
}

static Place place_item(const Place *list, int i)
{
    Place place = {.path = list->path, .json = json_array_get(list->json, (size_t)i)};
    snprintf(place.name, sizeof place.name, "%.60s[%d]", list->name, i);
    return place;
}

// A misspelt optional field would be lost without a word: refuse what is not known.
//   known   NULL-terminated
static int fields_check(const Place *object, const char *const *known)
{
    if (!json_is_object(object->json)) {
        return fault_kind(object, "an object");
    }
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)object->json, name, value)
    {
        int i = 0;
        while (known[i] != NULL && strcmp(known[i], name) != 0) {
            i++;
        }
        if (known[i] == NULL) {
            return fault(object, "found an unknown field \"%s\"", name);
        }
    }
    return 0;
}

static int text_read(const Place *place, char **text)
{
    if (!json_is_string(place->json)) {
        return fault_kind(place, "a string");
    }
    if (json_string_length(place->json) == 0) {
        return fault(place, "found an empty string, expected some text");
    }
    *text = strdup(json_string_value(place->json));
    return *text != NULL ? 0 : fault(place, "out of memory");
}

static int text_field_read(const Place *object, const char *field, char **text)
{
    Place place = place_field(object, field);
    return text_read(&place, text);
}

static int list_length_read(const Place *list, int most, int *length)
{
    if (!json_is_array(list->json)) {
        return fault_kind(list, "a list");
    }
    size_t found = json_array_size(list->json);
    if (found < 1 || found > (size_t)most) {
        return fault(list, "found %zu entries, expected 1 to %d", found, most);
    }
    *length = (int)found;
    return 0;
}

static int file_is_listed(const Manifest *manifest, const char *file)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (strcmp(manifest->files[i], file) == 0) {
            return 1;
        }
    }
    return 0;
}

static int files_read(const Place *object, Manifest *manifest)
{
    Place list = place_field(object, "files");
    int n_files;
    if (list_length_read(&list, MANIFEST_MAX_FILES, &n_files) != 0) {
        return -1;
    }
    for (int i = 0; i < n_files; i++) {
        Place place = place_item(&list, i);
        char *file = NULL;
        if (text_read(&place, &file) != 0) {
            return -1;
        }
        int listed = file_is_listed(manifest, file);
        manifest->files[manifest->n_files++] = file;
        // Staging copies by these names: none may lead out of the submission's folder.
        if (strchr(file, '/') != NULL || file[0] == '.') {
            return fault(&place, "found \"%s\", expected a plain file name", file);
        }
        if (listed) {
            return fault(&place, "found \"%s\" a second time", file);
        }
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

static int number_field_read(const Place *object, const char *field, int highest, int *number)
{
    Place place = place_field(object, field);
    if (!json_is_integer(place.json)) {
        return fault_kind(&place, "a whole number");
    }
    json_int_t found = json_integer_value(place.json);
    if (found < 1 || found > highest) {
        return fault(&place, "found %" JSON_INTEGER_FORMAT ", expected 1 to %d", found, highest);
    }
    *number = (int)found;
    return 0;
}

// Read the task's checks and their points. Each is counted in `task` from the start, so that
// manifest_free() sees it.
static int points_read(const Place *object, Task *task)
{
    Place points = place_field(object, "points");
    if (!json_is_object(points.json)) {
        return fault_kind(&points, "an object: the points of each check");
    }
    size_t found = json_object_size(points.json);
    if (found < 1 || found > MANIFEST_MAX_CHECKS) {
        return fault(&points, "found %zu entries, expected 1 to %d", found, MANIFEST_MAX_CHECKS);
    }
    const char *id;
    json_t *value;
    json_object_foreach((json_t *)points.json, id, value)
    {
        TaskCheck *check = &task->checks[task->n_checks++];
        *check = (TaskCheck){.id = strdup(id)};
        if (check->id == NULL) {
            return fault(&points, "out of memory");
        }
        if (number_field_read(&points, id, POINTS_OF_A_LAB, &check->points) != 0) {
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
    Place hints = place_field(object, "hints");
    if (hints.json == NULL) {
        return 0;
    }
    if (!json_is_object(hints.json)) {
        return fault_kind(&hints, "an object");
    }
    const char *id;
    json_t *value;
    json_object_foreach((json_t *)hints.json, id, value)
    {
        const int i = check_find(task, id);
        if (i < 0) {
            return fault(&hints, "found the check \"%s\", expected one of \"points\"", id);
        }
        if (text_field_read(&hints, id, &task->checks[i].hint) != 0) {
            return -1;
        }
    }
    return 0;
}

// Read the optional hints for who asks for more.
static int more_hints_read(const Place *object, Task *task)
{
    Place list = place_field(object, "more_hints");
    int n_hints;
    if (list.json == NULL) {
        return 0;
    }
    if (list_length_read(&list, MANIFEST_MORE_HINTS, &n_hints) != 0) {
        return -1;
    }
    if (n_hints != MANIFEST_MORE_HINTS) {
        return fault(&list, "found %d entries, expected %d", n_hints, MANIFEST_MORE_HINTS);
    }
    for (int i = 0; i < n_hints; i++) {
        Place place = place_item(&list, i);
        if (text_read(&place, &task->more_hints[i]) != 0) {
            return -1;
        }
    }
    return 0;
}

// Read the next task. It is counted in `manifest` from the start, so that manifest_free() sees it.
static int task_read(const Place *place, Manifest *manifest)
{
    static const char *const known[] = {"id",   "file",  "title",      "points",
                                        "hint", "hints", "more_hints", NULL};
    Task read = {0};
    Task *task = &manifest->tasks[manifest->n_tasks];
    *task = read;
    if (fields_check(place, known) != 0 || text_field_read(place, "id", &read.id) != 0) {
        return -1;
    }
    int given = manifest_task(manifest, read.id) != NULL;
    *task = read;
    manifest->n_tasks++;
    if (!id_is_plain(task->id)) {
        return fault(place, "found the id \"%s\", expected letters, digits, _ and -", task->id);
    }
    if (given) {
        return fault(place, "found the id \"%s\" a second time", task->id);
    }
    if (text_field_read(place, "file", &task->file) != 0 ||
        text_field_read(place, "title", &task->title) != 0 || points_read(place, task) != 0 ||
        text_field_read(place, "hint", &task->hint) != 0 || hints_read(place, task) != 0 ||
        more_hints_read(place, task) != 0) {
        return -1;
    }
    if (!file_is_listed(manifest, task->file)) {
        return fault(place, "found the file \"%s\", expected one of \"files\"", task->file);
    }
    return 0;
}

static int tasks_read(const Place *object, Manifest *manifest)
{
    Place list = place_field(object, "tasks");
    int n_tasks;
    if (list_length_read(&list, MANIFEST_MAX_TASKS, &n_tasks) != 0) {
        return -1;
    }
    int points = 0;
    for (int i = 0; i < n_tasks; i++) {
        Place place = place_item(&list, i);
        if (task_read(&place, manifest) != 0) {
            return -1;
        }
        for (int j = 0; j < manifest->tasks[i].n_checks; j++) {
            points += manifest->tasks[i].checks[j].points;
        }
    }
    if (points != POINTS_OF_A_LAB) {
        return fault(&list, "found %d points in all, expected %d", points, POINTS_OF_A_LAB);
    }
    return 0;
}

// Read what an optional figure counts. Its race is a program that is there before anything is
// handed in, and can hold no host files of a student's.
static int leaderboard_read(const Place *object, Manifest *manifest)
{
    const Place place = place_field(object, "leaderboard");
    if (place.json == NULL) {
        return 0;
    }
    if (manifest_has_host_files(manifest)) {
        return fault(&place, "found one in a lab with host files, expected kernels only");
    }
    return text_read(&place, &manifest->leaderboard);
}

// Read what the learner's desk wants to know; each field may be missing.
static int desk_fields_read(const Place *object, Manifest *manifest)
{
    enum { MOST_HOURS = 40 };
    const Place figure = place_field(object, "figure");
    if (json_object_get(object->json, "hours") != NULL &&
        number_field_read(object, "hours", MOST_HOURS, &manifest->hours) != 0) {
        return -1;
    }
    if (json_object_get(object->json, "look") != NULL &&
        text_field_read(object, "look", &manifest->look) != 0) {
        return -1;
    }
    if (figure.json == NULL) {
        return 0;
    }
    if (manifest->look == NULL) {
        return fault(&figure, "found one without \"look\", expected the options that draw it");
    }
    return text_read(&figure, &manifest->figure);
}

static int fields_read(const Place *object, Manifest *manifest)
{
    static const char *const known[] = {"title", "files", "tasks",  "leaderboard",
                                        "hours", "look",  "figure", NULL};
    if (fields_check(object, known) != 0 ||
        text_field_read(object, "title", &manifest->title) != 0 ||
        files_read(object, manifest) != 0 || tasks_read(object, manifest) != 0) {
        return -1;
    }
    return leaderboard_read(object, manifest) != 0 ? -1 : desk_fields_read(object, manifest);
}

static int file_read(const char *path, Manifest *manifest)
{
    Place place = {.path = path};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return fault(&place, "cannot read: %s", strerror(errno));
    }
    json_error_t error;
    json_t *json = json_loadf(file, JSON_REJECT_DUPLICATES, &error);
    fclose(file);
    if (json == NULL) {
        char shown[COMPLAINT_BYTES];
        complain("%s:%d: %s", path, error.line, message_show(error.text, shown, sizeof shown));
        return -1;
    }
    place.json = json;
    int result = fields_read(&place, manifest);
    json_decref(json);
    return result;
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
    snprintf(manifest->lab, sizeof manifest->lab, "%s", lab);
    if (file_read(path, manifest) != 0) {
        manifest_free(manifest);
        return -1;
    }
    return 0;
}

void manifest_free(Manifest *manifest)
{
    free(manifest->title);
    free(manifest->leaderboard);
    free(manifest->look);
    free(manifest->figure);
    for (int i = 0; i < manifest->n_files; i++) {
        free(manifest->files[i]);
    }
    for (int i = 0; i < manifest->n_tasks; i++) {
        Task *task = &manifest->tasks[i];
        free(task->id);
        free(task->file);
        free(task->title);
        free(task->hint);
        for (int j = 0; j < MANIFEST_MORE_HINTS; j++) {
            free(task->more_hints[j]);
        }
        for (int j = 0; j < task->n_checks; j++) {
            free(task->checks[j].id);
            free(task->checks[j].hint);
        }
    }
    *manifest = (Manifest){0};
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
