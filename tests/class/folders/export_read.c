// Reading a folder of submissions (see export_read.h).
//
// Read next: export_entries.c, export_level.c.
#include "export_read.h"

#include "complain.h"
#include "course_system.h"
#include "path.h"
#include "sheet.h"
#include "studip.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// How far below the folder that was given the entries may be: ILIAS has EXERCISE/Abgaben.
enum { MOST_LEVELS = 3 };

// ---- The folder --------------------------------------------------------------------------------

// Is a single file a student's, by the name that the export's system made? Else nobody knows whose
// it is.
static int has_owner(const Export *export, const Found *found)
{
    return !found->is_loose ||
           (export_is_exact(export, found) &&
            (found->name.file > 0 || found->is_listed || found->name.system == SYSTEM_ILIAS));
}

static int pass_over(Export *export, const char *file)
{
    char shown[ENTRY_NAME_BYTES];
    char **names = array_grown(export->passed_over, export->n_passed_over, sizeof *names);
    if (names == NULL) {
        return -1;
    }
    export->passed_over = names;
    entry_name_show(file, strlen(file), shown);
    names[export->n_passed_over] = strdup(shown);
    const int failed = names[export->n_passed_over] == NULL;
    export->n_passed_over += !failed;
    return failed ? -1 : 0;
}

// Beside names that a system made there may be others, as of a folder that the instructor added. If
// the system's are a student's own, the instructor can see it by that.
static void plain_tell(const Export *export)
{
    const Found *first = NULL;
    const int n =
        export->system != SYSTEM_NONE ? export_plain_count(export, export->system, &first) : 0;
    if (n > 0) {
        char shown[ENTRY_NAME_BYTES];
        entry_name_show(first->file, strlen(first->file), shown);
        const char *title = course_system(export->system)->title;
        complain("gradebook: %s: most names are as %s makes them, so they say whose the files are; "
                 "%d are not, such as \"%s\": if this folder is not %s' export, move the files "
                 "that look so out of it",
                 export->path, title, n, shown, title);
    }
}

// Decide which system made the names, read them so, and put aside the files without an owner.
static int names_settle(Export *export)
{
    int n = 0, failed = 0;
    if (export->system == SYSTEM_NONE && !studip_names_read(export)) {
        export->system = export_system_find(export);
        plain_tell(export);
        export_names_read(export);
    }
    for (int i = 0; i < export->n_found; i++) {
        Found found = export->found[i];
        // An archive is one of the files of an upload.
        found.is_loose |= !found.is_folder && !found.is_link && found.name.file > 0 &&
                          export_is_exact(export, &found) && !found.is_listed;
        if (has_owner(export, &found)) {
            export->found[n++] = found;
        } else {
            failed |= pass_over(export, found.file);
            free(found.file);
        }
    }
    export->n_found = n;
    return failed ? path_fault(export->path, "out of memory") : 0;
}

static void passed_over_tell(const Export *export)
{
    int is_low = 0;
    for (int i = 0; i < export->n_passed_over; i++) {
        is_low = is_low || export_is_source(export->passed_over[i]);
    }
    for (int i = 0; i < export->n_passed_over; i++) {
        if (export_is_list(export->passed_over[i])) {
            complain("gradebook: %s/%s: decides nothing: it is among what students handed in, so a "
                     "student may have written it; %s",
                     export->path, export->passed_over[i],
                     strcmp(export->passed_over[i], STUDIP_NAMES_FILE) == 0
                         ? "Stud.IP's own is above the folder of the files: export that folder"
                         : "Gradescope's own is beside folders submission_NUMBER and nothing else");
        }
    }
    if (export->n_passed_over > 0) {
        complain(
            "gradebook: %s: passed over %d files, as no name says whose they are, such as \"%s\"%s",
            export->path, export->n_passed_over, export->passed_over[0],
            is_low ? ": is this the folder of one student? Then give the one above it" : "");
    }
}

// ---- Reading -----------------------------------------------------------------------------------

static int found_compare(const void *left, const void *right)
{
    const Found *a = left;
    const Found *b = right;
    int order = strcmp(a->name.name, b->name.name);
    order = order != 0 ? order : strcmp(a->name.number, b->name.number);
    order = order != 0 ? order : strcmp(a->name.time, b->name.time);
    // What was typed into a form comes before the files, and single files before folders.
    order = order != 0 ? order : b->name.is_text - a->name.is_text;
    order = order != 0 ? order : b->is_loose - a->is_loose;
    return order != 0 ? order : strcmp(a->file, b->file);
}

static int names_compare(const void *left, const void *right)
{
    return strcmp(*(char *const *)left, *(char *const *)right);
}

// Gradescope's folders have numbers; who handed in is in a file beside them. A student may hand in
// a file of this name: it counts only where all there is are such folders, and it names them all.
static int submitters_read(Export *export)
{
    int n_lists = 0, n_named = 0;
    if (gradescope_names_load(export->path, &export->names) != 0) {
        return -1;
    }
    for (int i = 0; i < export->n_found; i++) {
        Found *found = &export->found[i];
        n_lists += found->is_loose && strcmp(found->file, GRADESCOPE_NAMES_FILE) == 0;
        found->submitters = found->is_folder && found->name.number[0] != '\0'
                                ? gradescope_names_find(&export->names, found->file)
                                : NULL;
        n_named += found->submitters != NULL;
    }
    if (n_lists == 0 || n_named == 0 || n_lists + n_named < export->n_found) {
        for (int i = 0; i < export->n_found; i++) {
            export->found[i].submitters = NULL;
        }
        return 0;
    }
    int n = 0;
    for (int i = 0; i < export->n_found; i++) {
        Found found = export->found[i];
        if (found.submitters == NULL) {
            free(found.file);
            continue;
        }
        gradescope_names_join(found.submitters, found.name.name);
        found.name.system = SYSTEM_GRADESCOPE;
        export->found[n++] = found;
    }
    export->n_found = n;
    export->system = SYSTEM_GRADESCOPE;
    return 0;
}

int export_read(const char *submissions, int is_unpacked, int lab_number, Export *export)
{
    char inner[PATH_MAX];
    *export = (Export){.is_unpacked = is_unpacked};
    path_make(export->path, "%s", submissions);
    int result = export_entries_read(export, lab_number, INT_MAX);
    for (int i = 0; result == 0 && i < MOST_LEVELS; i++) {
        const int leads_on = export_level_find(export, lab_number, inner);
        if (leads_on < 0) {
            return -1;
        }
        if (leads_on == 0) {
            break;
        }
        export_entries_free(export);
        memcpy(export->path, inner, sizeof inner);
        complain("gradebook: %s: this folder is graded, one or more below the one that was given",
                 export->path);
        result = export_entries_read(export, lab_number, INT_MAX);
    }
    if (result == 0) {
        result = submitters_read(export);
    }
    if (result == 0) {
        result = names_settle(export);
    }
    if (result == 0) {
        if (export->n_passed_over > 1) {
            qsort(export->passed_over, (size_t)export->n_passed_over, sizeof *export->passed_over,
                  names_compare);
        }
        passed_over_tell(export);
        export_teams_tell(export);
        git_clones_name(export);
    }
    if (result == 0 && export->n_found > 1) {
        qsort(export->found, (size_t)export->n_found, sizeof *export->found, found_compare);
    }
    return result;
}

void export_free(Export *export)
{
    export_entries_free(export);
    gradescope_names_free(&export->names);
}
