// Deciding by all names together (see export_system.h). Read next: system_names.h, the patterns.
#include "export_system.h"

#include <stdlib.h>
#include <string.h>

static int made_by(const Found *found, ExportSystem system)
{
    return (found->systems >> system & 1) != 0;
}

ExportSystem export_system_find(const Export *export)
{
    ExportSystem best = SYSTEM_NONE;
    int n_most = export->n_found / 2;
    for (ExportSystem system = SYSTEM_NONE + 1; system < N_SYSTEMS; system++) {
        int n = 0;
        for (int i = 0; i < export->n_found; i++) {
            n += made_by(&export->found[i], system);
        }
        if (n > n_most) {
            n_most = n;
            best = system;
        }
    }
    return best;
}

// How long what stands before the login is, in a name of Blackboard's: "Lab 0_".
static size_t title_length(const Found *found)
{
    return (size_t)(system_name_read(found->file, SYSTEM_BLACKBOARD).name.text - found->file);
}

// By title, the shortest first; behind all that are not Blackboard's.
static int title_compare(const void *left, const void *right)
{
    const Found *a = left;
    const Found *b = right;
    const int order = made_by(b, SYSTEM_BLACKBOARD) - made_by(a, SYSTEM_BLACKBOARD);
    return order != 0                 ? order
           : a->n_title != b->n_title ? (a->n_title > b->n_title) - (a->n_title < b->n_title)
                                      : strncmp(a->file, b->file, a->n_title);
}

// The title of the assignment, which stands before each login: the most frequent one, of equally
// frequent ones the shortest. Sorts the entries by their titles. Returns an entry with it, or NULL
// where Blackboard made none.
static const Found *title_find(Export *export)
{
    const Found *best = NULL;
    int n_most = 0, n = 0;
    for (int i = 0; i < export->n_found; i++) {
        Found *found = &export->found[i];
        found->n_title = made_by(found, SYSTEM_BLACKBOARD) ? title_length(found) : 0;
    }
    if (export->n_found > 1) {
        qsort(export->found, (size_t)export->n_found, sizeof *export->found, title_compare);
    }
    for (int i = 0; i < export->n_found; i++) {
        const Found *found = &export->found[i];
        n = i > 0 && title_compare(found - 1, found) == 0 ? n + 1 : 1;
        if (made_by(found, SYSTEM_BLACKBOARD) && n > n_most) {
            n_most = n;
            best = found;
        }
    }
    return best;
}

// Read a name of Blackboard's behind this title: a login may have underscores. What has another
// title is nobody's.
static void login_read(Found *found, const char *title, size_t n_title)
{
    const SystemName read = system_name_read(found->file, SYSTEM_BLACKBOARD);
    const char *end = read.name.text + read.name.length;
    if (strncmp(found->file, title, n_title) == 0 && end > found->file + n_title) {
        entry_name_show(found->file + n_title, (size_t)(end - found->file) - n_title,
                        found->name.name);
    } else {
        found->name.system = SYSTEM_NONE;
    }
}

void export_names_read(Export *export)
{
    const ExportSystem system = export->system;
    const Found *titled = system == SYSTEM_BLACKBOARD ? title_find(export) : NULL;
    for (int i = 0; i < export->n_found; i++) {
        Found *found = &export->found[i];
        if (system == SYSTEM_NONE || system == SYSTEM_MOODLE || !made_by(found, system)) {
            continue;
        }
        found->name = entry_name_read_export(found->file, found->is_folder, system);
        found->is_loose = found->is_loose || (system == SYSTEM_ILIAS && found->has_times);
        if (titled != NULL) {
            login_read(found, titled->file, titled->n_title);
        }
    }
}
