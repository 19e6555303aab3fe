// points: a lab's manifest with an instructor's own points, hints and limits.
//
//     points LAB POINTS.csv LAB.json
//
// POINTS.csv has a line for each check that differs (points 0: it is turned off), and settings:
//
//     check,points,hint,visible
//     child-inside,20,"Which cell holds the pixel?",
//     leaf-work,0,,
//     descent-leaf,,,no
//     TOTAL,95,,
//     TIME_LIMIT,30,,
//
// LAB.json is what solutions/LAB/lab.json would be with them (manifest.h): everything that reads
// one, from the grader to a bundle, takes it. Exit status: 0, or 2 after one message, where
// a line names no check, a number is none, a task would have no check left, or the points do not
// add up. Read next: sheet.h.
#include "clean_text.h"
#include "complain.h"
#include "json_text.h"
#include "manifest.h"
#include "number.h"
#include "path.h"
#include "sheet.h"

#include <jansson.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { CHECK, POINTS, HINT, VISIBLE, N_COLUMNS };
static const char *const titles[N_COLUMNS] = {"check", "points", "hint", "visible"};

enum { TOTAL_OF_A_LAB = 100, MOST_POINTS = 1000, MOST_SECONDS = 3600 };

typedef struct Own {
    const char *path;
    const Manifest *manifest;  // as the course has it
    json_t *lab;               // what is written
    json_t *changed;           // its field of that name
    Sheet sheet;
    int columns[N_COLUMNS];
    int n_off, n_points, n_hints, n_hidden;
} Own;

// A line, with its number for messages: the head is line 1.
typedef struct Line {
    int number;
    const char *cells[N_COLUMNS];
} Line;

static Line line_of(const Own *own, int i)
{
    Line line = {.number = i + 1};
    for (int c = 0; c < N_COLUMNS; c++) {
        const int column = own->columns[c];
        line.cells[c] = column >= 0 ? own->sheet.lines[i].cells[column] : "";
    }
    return line;
}

static int line_fault(const Own *own, const Line *line, int column, const char *expected)
{
    return sheet_fault(own->path, line->number, "%s: found \"%.100s\" in the column \"%s\", %s",
                       line->cells[CHECK], line->cells[column], titles[column], expected);
}

static int number_of(const Own *own, const Line *line, uint64_t lowest, uint64_t highest,
                     uint64_t *number)
{
    char expected[80];
    snprintf(expected, sizeof expected, "expected a whole number from %llu to %llu",
             (unsigned long long)lowest, (unsigned long long)highest);
    return number_read_unsigned(line->cells[POINTS], lowest, highest, number) == 0
               ? 0
               : line_fault(own, line, POINTS, expected);
}

// ---- Lines --------------------------------------------------------------------------------------

// A line that sets something for the whole lab. Returns 1, 0 where it is none, or -1 after one
// message.
static int setting_take(Own *own, const Line *line)
{
    uint64_t number;
    const char *name = line->cells[CHECK];
    const int is_seed = strcmp(name, "SEED") == 0, is_total = strcmp(name, "TOTAL") == 0;
    if (!is_seed && !is_total && strcmp(name, "TIME_LIMIT") != 0) {
        return 0;
    }
    const uint64_t highest = is_seed ? UINT64_MAX : is_total ? MOST_POINTS : MOST_SECONDS;
    if (number_of(own, line, is_seed ? 0 : 1, highest, &number) != 0) {
        return -1;
    }
    json_object_set_new(own->changed,
                        is_seed    ? "seed"
                        : is_total ? "total"
                                   : "time_limit",
                        is_seed ? json_string(line->cells[POINTS])
                                : json_integer((json_int_t)number));
    return 1;
}

// The task of lab.json that has a check, or NULL.
static json_t *task_of(const Own *own, const char *check)
{
    size_t i;
    json_t *task;
    json_array_foreach(json_object_get(own->lab, "tasks"), i, task)
    {
        if (json_object_get(json_object_get(task, "points"), check) != NULL) {
            return task;
        }
    }
    return NULL;
}

static int visible_take(Own *own, const Line *line)
{
    const char *visible = line->cells[VISIBLE];
    if (visible[0] == '\0' || strcmp(visible, "yes") == 0) {
        return 0;
    }
    if (strcmp(visible, "no") != 0) {
        return line_fault(own, line, VISIBLE, "expected yes or no");
    }
    own->n_hidden++;
    return json_array_append_new(json_object_get(own->changed, "hidden"),
                                 json_string(line->cells[CHECK]));
}

// A hint of one line, as all are.
static int hint_take(Own *own, const Line *line, json_t *task)
{
    if (line->cells[HINT][0] == '\0') {
        return 0;
    }
    char *hint = line_clean(line->cells[HINT]);
    if (json_object_get(task, "hints") == NULL) {
        json_object_set_new(task, "hints", json_object());
    }
    const int result =
        json_object_set_new(json_object_get(task, "hints"), line->cells[CHECK], json_string(hint));
    free(hint);
    own->n_hints++;
    return result;
}

// Is a check named by an earlier line, too? Returns that line, or 0.
static int named_before(const Own *own, const Line *line)
{
    for (int i = 1; i < line->number - 1; i++) {
        if (strcmp(line_of(own, i).cells[CHECK], line->cells[CHECK]) == 0) {
            return i + 1;
        }
    }
    return 0;
}

static int line_take(Own *own, const Line *line)
{
    uint64_t points;
    const char *id = line->cells[CHECK];
    const int before = named_before(own, line);
    if (before > 0) {
        return sheet_fault(own->path, line->number, "found %s, which line %d has already", id,
                           before);
    }
    const int is_setting = setting_take(own, line);
    if (is_setting != 0) {
        return is_setting < 0 ? -1 : 0;
    }
    json_t *task = task_of(own, id);
    if (task == NULL) {
        return sheet_fault(
            own->path, line->number,
            "found the check \"%.100s\", expected one of %s, or TOTAL, TIME_LIMIT or "
            "SEED",
            id, own->manifest->lab);
    }
    if (line->cells[POINTS][0] != '\0') {
        if (number_of(own, line, 0, MOST_POINTS, &points) != 0) {
            return -1;
        }
        own->n_off += points == 0;
        own->n_points += points > 0;
        json_object_set_new(json_object_get(task, "points"), id, json_integer((json_int_t)points));
    }
    return hint_take(own, line, task) != 0 || visible_take(own, line) != 0 ? -1 : 0;
}

// ---- The whole ----------------------------------------------------------------------------------

// Has each task a check left, and do the points add up? Returns 0, or -1 after one message.
static int sums_check(const Own *own)
{
    const json_t *total = json_object_get(own->changed, "total");
    json_int_t sum = 0;
    size_t i;
    json_t *task, *points;
    const char *id;
    json_array_foreach(json_object_get(own->lab, "tasks"), i, task)
    {
        json_int_t of_task = 0;
        json_object_foreach(json_object_get(task, "points"), id, points)
        {
            of_task += json_integer_value(points);
        }
        if (of_task == 0) {
            complain("points: %s: all checks of %s are turned off, expected one at least: the "
                     "others need its answer",
                     own->path, json_string_value(json_object_get(task, "id")));
            return -1;
        }
        sum += of_task;
    }
    if (sum != json_integer_value(total)) {
        complain("points: %s: all points add up to %d, expected %d; a line TOTAL,%d would say that "
                 "this is meant",
                 own->path, (int)sum, (int)json_integer_value(total), (int)sum);
        return -1;
    }
    return 0;
}

// "2 checks are off, 1 has other points (points.csv)", for reports.
static char *words_make(const Own *own)
{
    const struct {
        int n;
        const char *one, *many;
    } parts[] = {{own->n_off, "check is off", "checks are off"},
                 {own->n_points, "has other points", "have other points"},
                 {own->n_hints, "another hint", "other hints"},
                 {own->n_hidden, "does not show what it finds", "do not show what they find"}};
    char *words = NULL;
    size_t length;
    const char *slash = strrchr(own->path, '/');
    char *file = line_clean(slash != NULL ? slash + 1 : own->path);
    FILE *text = open_memstream(&words, &length);
    const char *between = "";
    fputs("your instructor's own: ", text);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (parts[i].n > 0) {
            fprintf(text, "%s%d %s", between, parts[i].n,
                    parts[i].n == 1 ? parts[i].one : parts[i].many);
            between = ", ";
        }
    }
    fprintf(text, "%s (%s)", between[0] == '\0' ? "all checks as the course has them" : "", file);
    fclose(text);
    free(file);
    return words;
}

static int lines_take(Own *own)
{
    int result = 0;
    for (int i = 1; result == 0 && i < own->sheet.n_lines; i++) {
        if (!sheet_line_is_empty(&own->sheet, &own->sheet.lines[i])) {
            const Line line = line_of(own, i);
            result = line_take(own, &line);
        }
    }
    return result == 0 ? sums_check(own) : -1;
}

// Read and check all, and write it. Returns 0, or -1 after one message.
static int own_make(Own *own, const char *output)
{
    Manifest made;
    own->changed = json_pack("{s:s, s:i, s:[]}", "says", "-", "total", TOTAL_OF_A_LAB, "hidden");
    json_object_set_new(own->lab, "changed", own->changed);
    if (sheet_load(own->path, "a list of checks with their points", &own->sheet) != 0 ||
        sheet_columns_find(&own->sheet, own->path, titles, N_COLUMNS, POINTS + 1, own->columns) !=
            0 ||
        lines_take(own) != 0) {
        return -1;
    }
    char *words = words_make(own);
    json_object_set_new(own->changed, "says", json_string(words));
    free(words);
    if (json_save(output, json_incref(own->lab), JSON_INDENT(2)) != 0) {
        return -1;
    }
    // What we write must be what everybody can read.
    if (manifest_load_file(output, own->manifest->lab, &made) != 0) {
        unlink(output);
        return -1;
    }
    manifest_free(&made);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fputs("usage: points LAB POINTS.csv LAB.json\n", stderr);
        return 2;
    }
    Manifest manifest;
    char path[PATH_MAX];
    json_error_t error;
    if (manifest_load(manifest_folder(argv[1]), argv[1], &manifest) != 0) {
        return 2;
    }
    path_make(path, "%s/%s/lab.json", manifest_folder(argv[1]), argv[1]);
    Own own = {.path = argv[2], .manifest = &manifest, .lab = json_load_file(path, 0, &error)};
    const int result = own.lab != NULL ? own_make(&own, argv[3]) : -1;
    sheet_free(&own.sheet);
    json_decref(own.lab);
    manifest_free(&manifest);
    return result == 0 ? 0 : 2;
}
