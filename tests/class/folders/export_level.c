// One folder too high or too low (see export_read.h).
//
// Read next: export_read.h, which system made the names.
#include "export_read.h"

#include "complain.h"
#include "course_system.h"
#include "path.h"
#include "studip.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// No more entries are read of a folder that may be one student's: else one student could make the
// whole class wait.
enum { MOST_LOOKED_AT = 1000 };

int export_is_source(const char *name)
{
    const char *ending = strrchr(name, '.');
    return ending != NULL && (strcmp(ending, ".cl") == 0 || strcmp(ending, ".c") == 0);
}

// The only entry beside files that no student hands in, or NULL where there are others or none.
static const Found *only_folder(const Export *export)
{
    const Found *only = NULL;
    int n = 0;
    for (int i = 0; i < export->n_found; i++) {
        const Found *found = &export->found[i];
        if (!found->is_loose || export_is_source(found->file)) {
            only = found;
            n++;
        }
    }
    return n == 1 && only->is_folder ? only : NULL;
}

static int is_for_submissions(const char *folder)
{
    static const char *const names[] = {"Abgaben", "Submissions", NULL};
    return name_is_one_of(folder, names);
}

// What is in a folder of an export.
typedef struct Below {
    ExportSystem system;  // that made most of the names
    int has_students;     // two at least
    int is_listed;        // Stud.IP's list beside the folder, above the files, names them
    int has_submissions;  // a folder "Abgaben", and this is its path
    char submissions[PATH_MAX];
} Below;

// Look at the first entries of a folder.
static Below look_below(const char *folder, int lab_number)
{
    Export inner = {0};
    Below below = {.system = SYSTEM_NONE};
    path_make(inner.path, "%s", folder);
    if (export_entries_read(&inner, lab_number, MOST_LOOKED_AT) == 0) {
        below.is_listed = studip_names_read(&inner);
        if (!below.is_listed) {
            inner.system = export_system_find(&inner);
            export_names_read(&inner);
        }
        below.system = inner.system;
        for (int i = 0; i < inner.n_found; i++) {
            const Found *found = &inner.found[i];
            if (found->is_folder && is_for_submissions(found->file)) {
                below.has_submissions = 1;
                path_make(below.submissions, "%s/%s", folder, found->file);
            }
            below.has_students |= i > 0 && !export_is_same_student(&inner, &inner.found[0], found);
        }
    }
    export_entries_free(&inner);
    return below;
}

// What comes before the advice to give a folder: nobody can give what is unpacked for a while.
static const char *unpack_first(const Export *export)
{
    return export->is_unpacked ? "unpack the archive yourself and " : "";
}

// Is the only entry a folder that leads to an export? ILIAS' "Abgaben" does, and the folder that
// Stud.IP's list beside it is about. Of any other folder, which may be a student's, it is only said
// that it looks so.
static int is_too_high(const Export *export, int lab_number, char inner[PATH_MAX])
{
    const Found *folder = only_folder(export);
    if (folder == NULL || export_system_find(export) != SYSTEM_NONE) {
        return 0;
    }
    path_make(inner, "%s/%s", export->path, folder->file);
    const Below below = look_below(inner, lab_number);
    if (below.has_submissions || below.is_listed ||
        (below.system != SYSTEM_NONE && is_for_submissions(folder->file))) {
        return 1;
    }
    if (below.system != SYSTEM_NONE) {
        complain("gradebook: %s: the only entry, whose files look as if %s had named them; if it "
                 "is the export, %sgive this folder",
                 inner, course_system(below.system)->title, unpack_first(export));
    }
    return 0;
}

// Is this number the only one in a name, as in "Lab 03: kd-trees"?
static int is_numbered(const char *name, int number)
{
    const char *digits = name + strcspn(name, "0123456789");
    char *end;
    const long first = strtol(digits, &end, 10);
    return end > digits && first == number && end[strcspn(end, "0123456789")] == '\0';
}

static int is_empty(const char *folder, int lab_number)
{
    Export inner = {0};
    path_make(inner.path, "%s", folder);
    const int is_read = export_entries_read(&inner, lab_number, 3) == 0;
    const int n = inner.n_found;
    export_entries_free(&inner);
    return is_read && n == 0;
}

// Does a folder hold the work of several students, by names that a system made, itself or in a
// folder "Abgaben"?
static int is_exercise(const char *folder, int lab_number)
{
    Below below = look_below(folder, lab_number);
    if (below.has_submissions && (below.system == SYSTEM_NONE || !below.has_students)) {
        below = look_below(below.submissions, lab_number);
    }
    return below.system != SYSTEM_NONE && below.has_students;
}

// The folders of several exercises side by side, as a whole course is exported: all of the folders
// that hold anything are exports, each of several students. Students cannot make a class look so
// while one of them hands in a folder of another kind. Finds those of which the number is the
// lab's. Returns how many folders hold exports, 0 where this is one exercise.
static int exercises_find(const Export *export, int lab_number, const Found **of_lab, int *n_of_lab)
{
    int n_folders = 0, n_exercises = 0;
    *n_of_lab = 0;
    for (int i = 0; i < export->n_found; i++) {
        char folder[PATH_MAX];
        const Found *found = &export->found[i];
        path_make(folder, "%s/%s", export->path, found->file);
        n_folders += !found->is_loose && !(found->is_folder && is_empty(folder, lab_number));
        if (!found->is_folder || !is_exercise(folder, lab_number)) {
            continue;
        }
        n_exercises++;
        if (is_numbered(found->file, lab_number)) {
            *of_lab = found;
            ++*n_of_lab;
        }
    }
    if (n_exercises > 0 && n_exercises < n_folders) {
        complain(
            "gradebook: %s: %d of its folders look like exports of several students, and %d do "
            "not: each is taken for one submission; if they are exercises, give the folder of "
            "one as SUBMISSIONS",
            export->path, n_exercises, n_folders - n_exercises);
    }
    return n_exercises >= 2 && n_exercises == n_folders ? n_exercises : 0;
}

// Has Gradescope written beside the folders whose they are?
static int is_of_gradescope(const Export *export)
{
    char names[PATH_MAX];
    struct stat status;
    path_make(names, "%s/" GRADESCOPE_NAMES_FILE, export->path);
    return lstat(names, &status) == 0;
}

// Where several exercises are side by side: go on with the lab's, or say what to do. Returns 1 with
// the folder to go on with, 0 where this is one exercise, or -1 after one message.
static int is_course(const Export *export, int lab_number, char inner[PATH_MAX])
{
    const Found *of_lab;
    int n_of_lab;
    if (export_system_find(export) != SYSTEM_NONE || is_of_gradescope(export) ||
        exercises_find(export, lab_number, &of_lab, &n_of_lab) == 0) {
        return 0;
    }
    if (n_of_lab == 1) {
        path_make(inner, "%s/%s", export->path, of_lab->file);
        return 1;
    }
    char shown[ENTRY_NAME_BYTES];
    const Found *first = &export->found[0];
    entry_name_show(first->file, strlen(first->file), shown);
    complain(
        "gradebook: %s: found several exercises side by side, and %s has the number %d; %sgive "
        "the folder of one of them, as SUBMISSIONS=\"%s/%s\"",
        export->path, n_of_lab == 0 ? "none" : "more than one", lab_number, unpack_first(export),
        export->is_unpacked ? "FOLDER" : export->path, shown);
    return -1;
}

int export_level_find(const Export *export, int lab_number, char inner[PATH_MAX])
{
    const int course = is_course(export, lab_number, inner);
    return course != 0 ? course : is_too_high(export, lab_number, inner);
}
