// Deciding by all names together (see export_read.h). Read next: course_system.h, the patterns.
#include "export_read.h"

#include "complain.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int made_by(const Found *found, ExportSystem system)
{
    return (found->readable >> system & 1) != 0;
}

static int looks_made_by(const Found *found, ExportSystem system)
{
    return (found->systems >> system & 1) != 0;
}

static int keys_compare(const void *left, const void *right)
{
    return strcmp(*(char *const *)left, *(char *const *)right);
}

// Of how many people the names are that a system may have made: one student can hand in many files.
// Returns -1 when memory runs out.
static int people_count(const Export *export, ExportSystem system)
{
    char **keys = calloc((size_t)export->n_found + 1, sizeof *keys);
    int n = 0, n_people = 0, failed = keys == NULL;
    for (int i = 0; !failed && i < export->n_found; i++) {
        const Found *found = &export->found[i];
        if (made_by(found, system)) {
            const EntryName name =
                system == SYSTEM_MOODLE
                    ? found->name
                    : entry_name_read_export(found->file, found->is_folder, system);
            failed = asprintf(&keys[n], "%s/%s", name.name, name.number) < 0;
            n += !failed;
        }
    }
    if (n > 1) {
        qsort(keys, (size_t)n, sizeof *keys, keys_compare);
    }
    for (int i = 0; i < n; i++) {
        n_people += i == 0 || strcmp(keys[i - 1], keys[i]) != 0;
    }
    for (int i = 0; i < n; i++) {
        free(keys[i]);
    }
    free(keys);
    return failed ? -1 : n_people;
}

int export_plain_count(const Export *export, ExportSystem system, const Found **first)
{
    int n = 0;
    for (int i = 0; i < export->n_found; i++) {
        const Found *found = &export->found[i];
        if (!found->is_loose && !looks_made_by(found, system)) {
            *first = n++ == 0 ? found : *first;
        }
    }
    return n;
}

ExportSystem export_system_find(const Export *export)
{
    // Of two that fit as many, the one whose pattern is the less likely by chance.
    static const ExportSystem order[] = {SYSTEM_MOODLE, SYSTEM_BLACKBOARD, SYSTEM_BRIGHTSPACE,
                                         SYSTEM_CANVAS, SYSTEM_ILIAS,      SYSTEM_VPL};
    ExportSystem best = SYSTEM_NONE;
    int n_most = export->n_found / 2;
    for (size_t s = 0; s < sizeof order / sizeof *order; s++) {
        const Found *plain = NULL;
        int n = 0;
        for (int i = 0; i < export->n_found; i++) {
            n += looks_made_by(&export->found[i], order[s]);
        }
        if (n > n_most &&
            people_count(export, order[s]) > export_plain_count(export, order[s], &plain)) {
            n_most = n;
            best = order[s];
        }
    }
    return best;
}

// How long what stands before the login is, in a name of Blackboard's: "Lab 0_".
static void title_measure(Found *found)
{
    const NamePart login = system_name_read(found->file, SYSTEM_BLACKBOARD).name;
    const int is_read = made_by(found, SYSTEM_BLACKBOARD);
    found->n_title = is_read ? (size_t)(login.text - found->file) : 0;
    found->n_login = is_read ? login.length : 0;
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

// By title, the shortest first, then by login; behind all that are not Blackboard's.
static int login_compare(const void *left, const void *right)
{
    const Found *a = left;
    const Found *b = right;
    const int order = title_compare(a, b);
    return order != 0 ? order
           : a->n_login != b->n_login
               ? (a->n_login > b->n_login) - (a->n_login < b->n_login)
               : strncmp(a->file + a->n_title, b->file + b->n_title, a->n_login);
}

// The title of the assignment, which stands before each login: the one before most different
// logins, of equally many the shortest. A student with an underscore in the login seems to have
// another title, however many files that are. Sorts the entries by their titles. Returns an entry
// with it, or NULL where Blackboard made none.
static const Found *title_find(Export *export)
{
    const Found *best = NULL;
    int n_most = 0, n = 0;
    for (int i = 0; i < export->n_found; i++) {
        title_measure(&export->found[i]);
    }
    if (export->n_found > 1) {
        qsort(export->found, (size_t)export->n_found, sizeof *export->found, login_compare);
    }
    for (int i = 0; i < export->n_found; i++) {
        const Found *found = &export->found[i];
        const int is_new_title = i == 0 || title_compare(found - 1, found) != 0;
        n = is_new_title ? 1 : n + (login_compare(found - 1, found) != 0);
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

// Has ILIAS written times before the files' names? In a newer release a student may have named
// files so. One alone cannot: more than half of the folders, and two at least, must have nothing
// but such files.
static int has_ilias_times(const Export *export)
{
    enum { FEWEST = 2 };
    int n_folders = 0, n_timed = 0;
    for (int i = 0; i < export->n_found; i++) {
        const Found *found = &export->found[i];
        n_folders += made_by(found, SYSTEM_ILIAS) && (found->has_times || found->has_untimed);
        n_timed += made_by(found, SYSTEM_ILIAS) && found->has_times;
    }
    return n_timed >= FEWEST && 2 * n_timed > n_folders;
}

void export_names_read(Export *export)
{
    const ExportSystem system = export->system;
    const Found *titled = system == SYSTEM_BLACKBOARD ? title_find(export) : NULL;
    export->has_ilias_times = system == SYSTEM_ILIAS && has_ilias_times(export);
    for (int i = 0; i < export->n_found; i++) {
        Found *found = &export->found[i];
        if (system == SYSTEM_NONE || system == SYSTEM_MOODLE || !made_by(found, system)) {
            continue;
        }
        if (system == SYSTEM_ILIAS && found->is_team) {
            found->name.system = system;  // under the folder's name
            continue;
        }
        found->name = entry_name_read_export(found->file, found->is_folder, system);
        found->is_loose = found->is_loose || (export->has_ilias_times && found->has_times);
        if (titled != NULL) {
            login_read(found, titled->file, titled->n_title);
        }
    }
}

void export_teams_tell(const Export *export)
{
    const Found *first = NULL;
    int n = 0;
    for (int i = 0; i < export->n_found; i++) {
        if (export->found[i].name.system == SYSTEM_ILIAS && export->found[i].is_team) {
            first = n++ == 0 ? &export->found[i] : first;
        }
    }
    if (n > 0) {
        complain(
            "gradebook: %s: %d teams of ILIAS: it names only the members who uploaded, and only "
            "they get the grade. For all write \"%s\" into a column \"Group\" of LIST=, or a "
            "line for each member into WHO=",
            export->path, n, first->name.name);
    }
}
