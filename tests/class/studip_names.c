// From Stud.IP's list of files to owners (see studip_names.h).
#include "studip_names.h"

#include "moment.h"
#include "path.h"
#include "studip_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        (EntryName){.system = SYSTEM_STUDIP, .file = (int)entry_name_number_length(found->file)};
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
    if (studip_list_load(folder, &list) != 0) {
        return 0;
    }
    const StudipFile *lines = studip_folder_find(&list, export, name, &n);
    for (int i = 0; lines != NULL && i < export->n_found; i++) {
        Found *found = &export->found[i];
        const StudipFile *listed = studip_file_find(lines, n, found->file);
        if (listed != NULL && !found->is_folder && !found->is_link) {
            owner_give(listed, n - (int)(listed - lines), found);
        }
    }
    studip_list_free(&list);
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
