// Reading a folder of submissions (see export.h).
//
// Read next: export_system.h, which system made the names.
#include "export.h"

#include "complain.h"
#include "contents.h"
#include "export_system.h"
#include "path.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    // How far below the folder that was given the entries may be: ILIAS has EXERCISE/Abgaben.
    MOST_LEVELS = 3,
    // Of a folder that may be one student's no more entries are read, and to see whether ILIAS has
    // named files: else one student makes the whole class wait.
    MOST_LOOKED_AT = 1000,
    MOST_LOOKED_AT_FOR_ILIAS = 20,
};

static int fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

// Room for one more in an array that doubles. Returns the array, or NULL when memory runs out.
static void *grown(void *array, int n, size_t size)
{
    return (n & (n - 1)) != 0 ? array : realloc(array, (n > 0 ? 2 * (size_t)n : 1) * size);
}

static int is_one_of(const char *file, const char *const *names)
{
    while (*names != NULL && strcmp(file, *names) != 0) {
        names++;
    }
    return *names != NULL;
}

// What unpackers and version control leave in a folder, and no student.
static int is_nobody(const char *file)
{
    static const char *const names[] = {".", "..", "__MACOSX", ".git", ".github", NULL};
    return is_one_of(file, names);
}

// Files that course systems and desktops add to an export.
static int is_systems(const char *file)
{
    static const char *const names[] = {
        GRADESCOPE_NAMES_FILE, "archive_filelist.csv", "index.html", ".DS_Store",
        "Thumbs.db",           "desktop.ini",          NULL};
    return is_one_of(file, names) || strncmp(file, "._", 2) == 0;
}

// ---- One entry ---------------------------------------------------------------------------------

// Does a folder hold files that ILIAS has named?
static int holds_ilias_files(int parent, const char *file)
{
    const int descriptor = openat(parent, file, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *entries = descriptor >= 0 ? fdopendir(descriptor) : NULL;
    if (descriptor >= 0 && entries == NULL) {
        close(descriptor);
    }
    int holds = 0, n = 0;
    struct dirent *entry;
    while (entries != NULL && !holds && n++ < MOST_LOOKED_AT_FOR_ILIAS &&
           (entry = readdir(entries)) != NULL) {
        holds = ilias_time_length(entry->d_name) > 0;
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return holds;
}

// Which systems may have made a name: a bit for each.
static unsigned systems_find(int parent, const Found *found)
{
    unsigned systems = found->name.system == SYSTEM_MOODLE ? 1U << SYSTEM_MOODLE : 0;
    for (ExportSystem system = SYSTEM_MOODLE + 1; system < N_SYSTEMS; system++) {
        const EntryName name = entry_name_read_export(found->file, found->is_folder, system);
        if (name.system == system &&
            (system != SYSTEM_ILIAS || holds_ilias_files(parent, found->file))) {
            systems |= 1U << system;
        }
    }
    return systems;
}

// Read what a file or folder is, under a name as if no system had made it: it is decided later
// whether one did.
static int found_read(int parent, const char *file, int lab_number, Found *found)
{
    struct stat status;
    if (fstatat(parent, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return -1;
    }
    const int is_file = S_ISREG(status.st_mode);
    *found = (Found){.file = strdup(file),
                     .name = entry_name_read(file, lab_number),
                     .is_folder = S_ISDIR(status.st_mode)};
    if (found->file == NULL) {
        return -1;
    }
    found->is_link = !found->is_folder && !is_file;
    found->systems = systems_find(parent, found);
    found->is_loose = is_file && archive_stem_length(file) == 0;
    return 0;
}

// Read the entries of a folder, or the first ones.
static int entries_read(Export *export, int lab_number, int n_most)
{
    DIR *entries = opendir(export->path);
    if (entries == NULL) {
        return fault(export->path, strerror(errno));
    }
    int failed = 0;
    struct dirent *entry;
    errno = 0;
    while (!failed && n_most-- > 0 && (entry = readdir(entries)) != NULL) {
        Found *found = grown(export->found, export->n_found, sizeof *found);
        if (found == NULL) {
            failed = 1;
            break;
        }
        export->found = found;
        found += export->n_found;
        if (!is_nobody(entry->d_name)) {
            failed = found_read(dirfd(entries), entry->d_name, lab_number, found) != 0;
            const int is_kept = !failed && !(found->is_loose && is_systems(found->file));
            export->n_found += is_kept;
            if (!failed && !is_kept) {
                free(found->file);
            }
        }
        errno = failed ? errno : 0;
    }
    const int result = failed || errno != 0 ? fault(export->path, strerror(errno)) : 0;
    closedir(entries);
    return result;
}

// ---- The folder --------------------------------------------------------------------------------

// Is a single file a student's, by the name that the export's system made? Else nobody knows whose
// it is.
static int has_owner(const Export *export, const Found *found)
{
    return !found->is_loose || (export_is_exact(export, found) &&
                                (found->name.file > 0 || found->name.system == SYSTEM_ILIAS));
}

static int pass_over(Export *export, const char *file)
{
    char shown[ENTRY_NAME_BYTES];
    char **names = grown(export->passed_over, export->n_passed_over, sizeof *names);
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

// Decide which system made the names, read them so, and put aside the files without an owner.
static int names_settle(Export *export)
{
    int n = 0, failed = 0;
    export->system = export_system_find(export);
    export_names_read(export);
    for (int i = 0; i < export->n_found; i++) {
        Found found = export->found[i];
        // An archive is one of the files of an upload.
        found.is_loose |= !found.is_folder && !found.is_link && found.name.file > 0 &&
                          export_is_exact(export, &found);
        if (has_owner(export, &found)) {
            export->found[n++] = found;
        } else {
            failed |= pass_over(export, found.file);
            free(found.file);
        }
    }
    export->n_found = n;
    return failed ? fault(export->path, "out of memory") : 0;
}

// The prefix that all clones of an assignment have, "rays-" of "rays-ada", "rays-bob", "rays-cy":
// of folders that are repositories. Two may have part of a name in common. Returns its length, or
// 0.
static size_t clones_prefix(const Export *export)
{
    size_t length = 0;
    for (int i = 0; i < export->n_found; i++) {
        char repository[PATH_MAX];
        struct stat status;
        const char *file = export->found[i].file, *first = export->found[0].file;
        path_make(repository, "%s/%s/.git", export->path, file);
        if (lstat(repository, &status) != 0) {
            return 0;
        }
        size_t n = i == 0 ? strlen(file) : 0;
        while (i > 0 && n < length && file[n] == first[n]) {
            n++;
        }
        length = n;
    }
    while (length > 0 && export->found[0].file[length - 1] != '-') {
        length--;
    }
    return length;
}

static void clones_name(Export *export)
{
    enum { FEWEST = 3 };
    const Found *first = export->found;
    // "lab03-ada" was read already.
    const int is_plain = export->n_found >= FEWEST && strcmp(first->name.name, first->file) == 0;
    const size_t length = is_plain ? clones_prefix(export) : 0;
    for (int i = 0; length > 0 && i < export->n_found; i++) {
        const char *name = export->found[i].file + length;
        entry_name_show(name, strlen(name), export->found[i].name.name);
    }
}

// ---- One folder too high or too low ------------------------------------------------------------

static void entries_free(Export *export)
{
    for (int i = 0; i < export->n_found; i++) {
        free(export->found[i].file);
    }
    for (int i = 0; i < export->n_passed_over; i++) {
        free(export->passed_over[i]);
    }
    free(export->found);
    free(export->passed_over);
    export->found = NULL, export->passed_over = NULL;
    export->n_found = export->n_passed_over = 0;
}

// One of a lab's files, where folders of students were expected?
static int is_source(const char *name)
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
        if (!found->is_loose || is_source(found->file)) {
            only = found;
            n++;
        }
    }
    return n == 1 && only->is_folder ? only : NULL;
}

static int is_for_submissions(const char *folder)
{
    static const char *const names[] = {"Abgaben", "Submissions", NULL};
    return is_one_of(folder, names);
}

// What is in a folder of an export.
typedef struct Below {
    ExportSystem system;  // that made most of the names
    int has_students;     // two at least
    int has_submissions;  // a folder "Abgaben", and this is its path
    char submissions[PATH_MAX];
} Below;

// Look at the first entries of a folder.
static Below look_below(const char *folder, int lab_number)
{
    Export inner = {0};
    Below below = {.system = SYSTEM_NONE};
    path_make(inner.path, "%s", folder);
    if (entries_read(&inner, lab_number, MOST_LOOKED_AT) == 0) {
        below.system = inner.system = export_system_find(&inner);
        export_names_read(&inner);
        for (int i = 0; i < inner.n_found; i++) {
            const Found *found = &inner.found[i];
            if (found->is_folder && is_for_submissions(found->file)) {
                below.has_submissions = 1;
                path_make(below.submissions, "%s/%s", folder, found->file);
            }
            below.has_students |= i > 0 && !export_is_same_student(&inner, &inner.found[0], found);
        }
    }
    entries_free(&inner);
    return below;
}

// What comes before the advice to give a folder: nobody can give what is unpacked for a while.
static const char *unpack_first(const Export *export)
{
    return export->is_unpacked ? "unpack the archive yourself and " : "";
}

// Is the only entry a folder that leads to an export? ILIAS' "Abgaben" does. Of any other folder,
// which may be a student's, it is only said that it looks so.
static int is_too_high(const Export *export, int lab_number, char inner[PATH_MAX])
{
    const Found *folder = only_folder(export);
    if (folder == NULL || export_system_find(export) != SYSTEM_NONE) {
        return 0;
    }
    path_make(inner, "%s/%s", export->path, folder->file);
    const Below below = look_below(inner, lab_number);
    if (below.has_submissions ||
        (below.system != SYSTEM_NONE && is_for_submissions(folder->file))) {
        return 1;
    }
    if (below.system != SYSTEM_NONE) {
        complain("gradebook: %s: the only entry, whose files look as if %s had named them; if it "
                 "is the export, %sgive this folder",
                 inner, system_title(below.system), unpack_first(export));
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

// The folders of several exercises side by side, as a whole course is exported: most of the folders
// hold exports, each of several students. No student can do that alone, as the others of a class
// would have to hand in such folders, too. Finds those of which the number is the lab's. Returns
// how many folders hold exports, 0 where this is one exercise.
static int exercises_find(const Export *export, int lab_number, const Found **of_lab, int *n_of_lab)
{
    int n_folders = 0, n_exercises = 0;
    *n_of_lab = 0;
    for (int i = 0; i < export->n_found; i++) {
        char folder[PATH_MAX];
        const Found *found = &export->found[i];
        n_folders += !found->is_loose;
        path_make(folder, "%s/%s", export->path, found->file);
        if (!found->is_folder || !is_exercise(folder, lab_number)) {
            continue;
        }
        n_exercises++;
        if (is_numbered(found->file, lab_number)) {
            *of_lab = found;
            ++*n_of_lab;
        }
    }
    return n_exercises >= 2 && 2 * n_exercises > n_folders ? n_exercises : 0;
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

static void passed_over_tell(const Export *export)
{
    int is_low = 0;
    for (int i = 0; i < export->n_passed_over; i++) {
        is_low = is_low || is_source(export->passed_over[i]);
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

// Gradescope's folders have numbers; who handed in is in a file beside them.
static int submitters_read(Export *export)
{
    if (gradescope_names_load(export->path, &export->names) != 0) {
        return -1;
    }
    for (int i = 0; i < export->n_found; i++) {
        Found *found = &export->found[i];
        found->submitters = gradescope_names_find(&export->names, found->file);
        if (found->submitters != NULL) {
            gradescope_names_join(found->submitters, found->name.name);
        }
    }
    return 0;
}

int export_read(const char *submissions, int is_unpacked, int lab_number, Export *export)
{
    char inner[PATH_MAX];
    *export = (Export){.is_unpacked = is_unpacked};
    path_make(export->path, "%s", submissions);
    int result = entries_read(export, lab_number, INT_MAX);
    for (int i = 0; result == 0 && i < MOST_LEVELS; i++) {
        const int course = is_course(export, lab_number, inner);
        if (course < 0) {
            return -1;
        }
        if (course == 0 && !is_too_high(export, lab_number, inner)) {
            break;
        }
        entries_free(export);
        memcpy(export->path, inner, sizeof inner);
        complain("gradebook: %s: this folder is graded, one or more below the one that was given",
                 export->path);
        result = entries_read(export, lab_number, INT_MAX);
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
        clones_name(export);
        result = submitters_read(export);
    }
    if (result == 0 && export->n_found > 1) {
        qsort(export->found, (size_t)export->n_found, sizeof *export->found, found_compare);
    }
    return result;
}

void export_free(Export *export)
{
    entries_free(export);
    gradescope_names_free(&export->names);
}

int export_is_exact(const Export *export, const Found *found)
{
    return found->submitters != NULL ||
           (export->system != SYSTEM_NONE && found->name.system == export->system);
}

int export_is_same_student(const Export *export, const Found *a, const Found *b)
{
    return export->system != SYSTEM_NONE && a->name.system == export->system &&
           b->name.system == export->system && strcmp(a->name.name, b->name.name) == 0 &&
           strcmp(a->name.number, b->name.number) == 0;
}

int export_attempt_end(const Export *export, int i)
{
    const Found *first = &export->found[i];
    int end = i + 1;
    while (first->is_loose && end < export->n_found && export->found[end].is_loose &&
           first->name.is_text == export->found[end].name.is_text &&
           export_is_same_student(export, first, &export->found[end]) &&
           strcmp(first->name.time, export->found[end].name.time) == 0) {
        end++;
    }
    return end;
}
