// Stud.IP's list of files, and from it to owners (see studip.h).
//
// Paths and names in it are other people's texts: they are compared and shown, and never opened.
#include "studip.h"

#include "complain.h"
#include "moment.h"
#include "name_likeness.h"
#include "path.h"
#include "sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

// A line of the list.
typedef struct StudipFile {
    const char *owner[2];  // first and last name
    const char *date;
    const char *path;
    size_t n_folder;              // how long the path is before the file's name
    char file[ENTRY_NAME_BYTES];  // composed
} StudipFile;

typedef struct StudipList {
    Sheet sheet;
    StudipFile *lines;  // by folder, then by file
    int n_lines;
} StudipList;

// A list of a whole course is shorter. A student's own could else cost much memory.
enum { MOST_BYTES = 1024 * 1024 };

enum { FIRST, LAST, DATE, PATH, N_COLUMNS };

// ---- The list ----------------------------------------------------------------------------------

// The columns, by their titles in German and in English. Returns -1 where one is missing.
static int columns_find(const Sheet *sheet, int columns[N_COLUMNS])
{
    static const char *const titles[N_COLUMNS][3] = {[FIRST] = {"Vorname", "First name"},
                                                     [LAST] = {"Nachname", "Last name", "Surname"},
                                                     [DATE] = {"Datum", "Date"},
                                                     [PATH] = {"Pfad", "Path"}};
    for (int i = 0; i < N_COLUMNS; i++) {
        columns[i] = -1;
        for (int c = sheet->n_columns - 1; c >= 0; c--) {
            for (int t = 0; t < 3 && titles[i][t] != NULL; t++) {
                columns[i] =
                    strcasecmp(sheet->lines[0].cells[c], titles[i][t]) == 0 ? c : columns[i];
            }
        }
        if (columns[i] < 0 && i != DATE) {
            return -1;
        }
    }
    return 0;
}

static int folders_compare(const StudipFile *a, const StudipFile *b)
{
    const int order = (a->n_folder > b->n_folder) - (a->n_folder < b->n_folder);
    return order != 0 ? order : strncmp(a->path, b->path, a->n_folder);
}

static int listed_compare(const void *left, const void *right)
{
    const int order = folders_compare(left, right);
    return order != 0 ? order
                      : strcmp(((const StudipFile *)left)->file, ((const StudipFile *)right)->file);
}

static void lines_read(StudipList *list, const int columns[N_COLUMNS])
{
    for (int i = 1; i < list->sheet.n_lines; i++) {
        char *const *cells = list->sheet.lines[i].cells;
        const char *path = cells[columns[PATH]];
        const char *slash = strrchr(path, '/');
        const char *file = slash != NULL ? slash + 1 : path;
        if (file[0] == '\0' || strlen(file) > NAME_MAX) {
            continue;
        }
        StudipFile *listed = &list->lines[list->n_lines++];
        *listed = (StudipFile){.owner = {cells[columns[FIRST]], cells[columns[LAST]]},
                               .date = columns[DATE] >= 0 ? cells[columns[DATE]] : "",
                               .path = path,
                               .n_folder = (size_t)(file - path)};
        name_compose(file, listed->file);
    }
    if (list->n_lines > 1) {
        qsort(list->lines, (size_t)list->n_lines, sizeof *list->lines, listed_compare);
    }
}

// Returns 0, or -1 where there is none, or after one message.
static int list_load(const char *folder, StudipList *list)
{
    char path[PATH_MAX];
    struct stat status;
    int columns[N_COLUMNS];
    *list = (StudipList){0};
    path_make(path, "%s/" STUDIP_NAMES_FILE, folder);
    // No link and no pipe: a student may have made it.
    if (lstat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
        return -1;
    }
    if (status.st_size > MOST_BYTES) {
        complain("gradebook: %s: not read: found %lld bytes, expected Stud.IP's list of files, of "
                 "at most %d",
                 path, (long long)status.st_size, MOST_BYTES);
        return -1;
    }
    if (sheet_load(path, "Stud.IP's list of files", &list->sheet) != 0) {
        return -1;
    }
    if (columns_find(&list->sheet, columns) != 0) {
        complain("gradebook: %s: not read: found no columns \"Vorname\", \"Nachname\" and "
                 "\"Pfad\", or \"First name\", \"Last name\" and \"Path\"",
                 path);
        sheet_free(&list->sheet);
        return -1;
    }
    list->lines = calloc((size_t)list->sheet.n_lines, sizeof *list->lines);
    if (list->lines == NULL) {
        complain("gradebook: %s: not read: out of memory", path);
        sheet_free(&list->sheet);
        return -1;
    }
    lines_read(list, columns);
    return 0;
}

static void list_free(StudipList *list)
{
    free(list->lines);
    sheet_free(&list->sheet);
}

// ---- The folder --------------------------------------------------------------------------------

// The first line about a file among n lines of one folder; NULL where there is none.
static const StudipFile *file_find(const StudipFile *lines, int n, const char *file)
{
    char composed[ENTRY_NAME_BYTES];
    int begin = 0, end = n;
    name_compose(file, composed);
    while (begin < end) {
        const int middle = begin + (end - begin) / 2;
        if (strcmp(lines[middle].file, composed) < 0) {
            begin = middle + 1;
        } else {
            end = middle;
        }
    }
    return begin < n && strcmp(lines[begin].file, composed) == 0 ? &lines[begin] : NULL;
}

// Is this the last part of a path that ends in a slash, "Course/Lab 0/"?
static int ends_in_folder(const StudipFile *listed, const char *name)
{
    const size_t length = strlen(name), n = listed->n_folder;
    return n > length && strncmp(listed->path + n - 1 - length, name, length) == 0 &&
           (n - 1 == length || listed->path[n - 2 - length] == '/');
}

// The folder of the list that the export's is: the one that names most of its entries, more than
// half, and more than any other does. Returns its lines, *n of them, by file, or NULL.
//   name   what it is called in the list, with those above it or without
static const StudipFile *folder_find(const StudipList *list, const Export *export, const char *name,
                                     int *n)
{
    const StudipFile *best = NULL;
    int n_most = export->n_found / 2, is_tie = 0;
    for (int begin = 0, end; begin < list->n_lines; begin = end) {
        const StudipFile *first = &list->lines[begin];
        int n_named = 0;
        for (end = begin + 1;
             end < list->n_lines && folders_compare(first, first + end - begin) == 0; end++) {
        }
        // Also where somebody made a list of very many folders, all this takes little time.
        if (2 * (end - begin) <= export->n_found || !ends_in_folder(first, name)) {
            continue;
        }
        for (int i = 0; i < export->n_found; i++) {
            n_named += file_find(first, end - begin, export->found[i].file) != NULL;
        }
        is_tie = n_named == n_most ? best != NULL : is_tie && n_named < n_most;
        if (n_named > n_most) {
            n_most = n_named;
            best = first;
            *n = end - begin;
        }
    }
    return is_tie ? NULL : best;
}

// ---- Owners ------------------------------------------------------------------------------------

static int is_same_owner(const StudipFile *a, const StudipFile *b)
{
    return strcmp(a->owner[0], b->owner[0]) == 0 && strcmp(a->owner[1], b->owner[1]) == 0;
}

static void owner_give(const StudipFile *listed, int n_behind, Found *found)
{
    char owner[ENTRY_NAME_BYTES];
    for (int i = 1; i < n_behind && strcmp(listed[i].file, listed->file) == 0; i++) {
        if (!is_same_owner(listed, &listed[i])) {
            // Its name may be somebody's, so it is shown as that of a file.
            entry_name_show(found->file, strlen(found->file), found->name.name);
            return;
        }
    }
    const char *first = listed->owner[0], *last = listed->owner[1];
    const int n = snprintf(owner, sizeof owner, "%s%s%s", first,
                           first[0] != '\0' && last[0] != '\0' ? " " : "", last);
    if (n <= 0 || n > NAME_MAX) {
        return;  // an account that is gone
    }
    found->name =
        (EntryName){.system = SYSTEM_STUDIP, .file = (int)studip_number_length(found->file)};
    entry_name_show(owner, (size_t)n, found->name.name);
    snprintf(found->name.time, sizeof found->name.time, "%s", listed->date);
    memcpy(found->listed_time, found->name.time, sizeof found->listed_time);
    found->is_listed = 1;
}

static int owners_compare(const void *left, const void *right)
{
    const Found *a = left, *b = right;
    const int order = b->is_listed - a->is_listed;
    return order != 0 ? order : strcmp(a->name.name, b->name.name);
}

// Make one attempt of an owner's files, n of them, or several entries.
static void files_join(Found *found, int n)
{
    int n_loose = 0;
    const char *last = "";
    time_t latest = 0, moment;
    for (int i = 0; i < n; i++) {
        n_loose += found[i].is_loose;
    }
    const int is_one = n - n_loose <= 1;
    for (int i = 0; i < n; i++) {
        if (!is_one && !found[i].is_loose) {
            found[i].name.system = SYSTEM_NONE;
            continue;
        }
        found[i].is_loose = n > 1;
        if (moment_read(found[i].name.time, &moment) == 0 && (last[0] == '\0' || moment > latest)) {
            latest = moment;
            last = found[i].name.time;
        }
    }
    char time[sizeof found->name.time];
    snprintf(time, sizeof time, "%s", last);
    for (int i = 0; i < n; i++) {
        if (found[i].name.system == SYSTEM_STUDIP) {
            memcpy(found[i].name.time, time, sizeof time);
        }
    }
}

static int list_apply(const char *folder, const char *name, Export *export)
{
    StudipList list;
    int n = 0;
    if (list_load(folder, &list) != 0) {
        return 0;
    }
    const StudipFile *lines = folder_find(&list, export, name, &n);
    for (int i = 0; lines != NULL && i < export->n_found; i++) {
        Found *found = &export->found[i];
        const StudipFile *listed = file_find(lines, n, found->file);
        if (listed != NULL && !found->is_folder && !found->is_link) {
            owner_give(listed, n - (int)(listed - lines), found);
        }
    }
    list_free(&list);
    if (lines == NULL) {
        return 0;
    }
    qsort(export->found, (size_t)export->n_found, sizeof *export->found, owners_compare);
    for (int i = 0, end; i < export->n_found && export->found[i].is_listed; i = end) {
        for (end = i + 1;
             end < export->n_found && owners_compare(&export->found[i], &export->found[end]) == 0;
             end++) {
        }
        files_join(&export->found[i], end - i);
    }
    export->system = SYSTEM_STUDIP;
    return 1;
}

// A path at its last slash but `n_slashes`, which is cut. Returns what is behind it; NULL where
// there are fewer slashes.
static const char *path_cut(char *path, int n_slashes)
{
    char *end = path + strlen(path);
    while (end > path && (*--end != '/' || n_slashes-- > 0)) {
    }
    if (end == path || end[1] == '\0') {
        return NULL;
    }
    *end = '\0';
    return end + 1;
}

int studip_names_read(Export *export)
{
    enum { MOST_ABOVE = 2 };
    char path[PATH_MAX], above[PATH_MAX];
    if (export->n_found == 0 || realpath(export->path, path) == NULL) {
        return 0;
    }
    for (int n = MOST_ABOVE; n > 0; n--) {
        memcpy(above, path, sizeof above);
        const char *name = path_cut(above, n - 1);
        if (name != NULL && list_apply(above, name, export)) {
            return 1;
        }
    }
    return 0;
}

size_t studip_number_length(const char *file)
{
    const size_t n_digits = file[0] == '[' ? strspn(file + 1, "0123456789") : 0;
    return n_digits > 0 && strncmp(file + 1 + n_digits, "]_", 2) == 0 ? n_digits + 3 : 0;
}

const CourseSystem studip_system = {
    .title = "Stud.IP",
    .identity = "`archive_filelist.csv` above the folder of the files",
    .identity_writer = WRITER_SYSTEM,
    .time = "`archive_filelist.csv` above the folder of the files",
    .time_writer = WRITER_SYSTEM,
};
