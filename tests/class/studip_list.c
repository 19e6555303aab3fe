// Reading Stud.IP's list of files (see studip_list.h). Read next: studip_names.c.
#include "studip_list.h"

#include "complain.h"
#include "name_likeness.h"
#include "path.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

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

int studip_list_load(const char *folder, StudipList *list)
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

void studip_list_free(StudipList *list)
{
    free(list->lines);
    sheet_free(&list->sheet);
}

// ---- The folder --------------------------------------------------------------------------------

const StudipFile *studip_file_find(const StudipFile *lines, int n, const char *file)
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

const StudipFile *studip_folder_find(const StudipList *list, const Export *export, const char *name,
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
            n_named += studip_file_find(first, end - begin, export->found[i].file) != NULL;
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
