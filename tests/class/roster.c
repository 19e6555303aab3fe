// Reading a folder of submissions (see roster.h).
//
// Only names are read here; what is inside an entry is the grader's, in its sandbox. The links
// spare the driver, a shell script, every name that somebody else chose. Read next: entry_name.h,
// grade_class.sh.
#include "roster.h"

#include "complain.h"
#include "path.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

// ---- Entries ---------------------------------------------------------------------------------

// What one entry of the folder is, before it is known who else is there.
typedef struct Found {
    char *file;  // its name, as it is
    EntryName name;
    int is_link;
    const GradescopeEntry *submitters;  // or NULL
} Found;

typedef struct Folder {
    const char *path;
    Found *found;
    int n_found;
    int n_passed_over;  // files that are no archives
    GradescopeNames names;
    int is_moodles;  // Moodle's export, and nothing else
} Folder;

// What unpackers and version control leave in a folder, and no student.
static int is_nobody(const char *file)
{
    static const char *const names[] = {".", "..", "__MACOSX", ".git", ".github", NULL};
    int i = 0;
    while (names[i] != NULL && strcmp(file, names[i]) != 0) {
        i++;
    }
    return names[i] != NULL;
}

static int entry_add(Folder *folder, int descriptor, const char *file, int lab_number)
{
    struct stat status;
    if (fstatat(descriptor, file, &status, AT_SYMLINK_NOFOLLOW) != 0) {
        return fault(folder->path, strerror(errno));
    }
    if (S_ISREG(status.st_mode) && entry_name_archive_stem(file) == 0) {
        folder->n_passed_over += strcmp(file, GRADESCOPE_NAMES_FILE) != 0;
        return 0;
    }
    if ((folder->n_found & (folder->n_found - 1)) == 0) {
        const size_t n = folder->n_found > 0 ? 2 * (size_t)folder->n_found : 1;
        Found *grown = realloc(folder->found, n * sizeof *grown);
        if (grown == NULL) {
            return fault(folder->path, "out of memory");
        }
        folder->found = grown;
    }
    Found *found = &folder->found[folder->n_found];
    *found = (Found){.file = strdup(file), .name = entry_name_read(file, lab_number)};
    found->is_link = !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    folder->n_found += found->file != NULL;
    return found->file != NULL ? 0 : fault(folder->path, "out of memory");
}

static int folder_read(Folder *folder, int lab_number)
{
    DIR *entries = opendir(folder->path);
    if (entries == NULL) {
        return fault(folder->path, strerror(errno));
    }
    int result = 0;
    struct dirent *entry;
    errno = 0;
    while (result == 0 && (entry = readdir(entries)) != NULL) {
        if (!is_nobody(entry->d_name)) {
            result = entry_add(folder, dirfd(entries), entry->d_name, lab_number);
        }
        errno = 0;
    }
    if (result == 0 && errno != 0) {
        result = fault(folder->path, strerror(errno));
    }
    closedir(entries);
    if (folder->n_passed_over > 0) {
        complain("gradebook: %s: passed over %d files that are no archives (Moodle: download the "
                 "submissions in folders)",
                 folder->path, folder->n_passed_over);
    }
    return result;
}

static void folder_free(Folder *folder)
{
    for (int i = 0; i < folder->n_found; i++) {
        free(folder->found[i].file);
    }
    free(folder->found);
    gradescope_names_free(&folder->names);
}

// "Ada Lovelace & Grace Hopper", and "..." for those that there is no room for: half a name may be
// no text. Nothing when no name is known.
static void names_join(const GradescopeEntry *entry, char text[ENTRY_NAME_BYTES])
{
    size_t length = 0;
    for (int i = 0; i < entry->n_members; i++) {
        const char *name = entry->members[i].name;
        const char *joint = length > 0 ? " & " : "";
        if (length + strlen(joint) + strlen(name) + sizeof " & ..." > ENTRY_NAME_BYTES) {
            snprintf(text + length, ENTRY_NAME_BYTES - length, "%s...", joint);
            return;
        }
        if (name[0] != '\0') {
            length +=
                (size_t)snprintf(text + length, ENTRY_NAME_BYTES - length, "%s%s", joint, name);
        }
    }
}

// Gradescope's folders have numbers; who handed in is in a file beside them.
static int names_apply(Folder *folder)
{
    if (gradescope_names_load(folder->path, &folder->names) != 0) {
        return -1;
    }
    for (int i = 0; i < folder->n_found; i++) {
        Found *found = &folder->found[i];
        found->submitters = gradescope_names_find(&folder->names, found->file);
        if (found->submitters != NULL) {
            names_join(found->submitters, found->name.name);
        }
    }
    return 0;
}

// ---- Students --------------------------------------------------------------------------------

static int students_compare(const void *left, const void *right)
{
    const Found *a = left;
    const Found *b = right;
    int order = strcmp(a->name.name, b->name.name);
    order = order != 0 ? order : strcmp(a->name.number, b->name.number);
    // What was typed into a form comes before the files.
    order = order != 0 ? order : b->name.is_text - a->name.is_text;
    return order != 0 ? order : strcmp(a->file, b->file);
}

// Is every name Moodle's? Where others have chosen names, too, one of them may look like Moodle's:
// then it is reported to whoever runs this.
static int is_moodles(const Folder *folder)
{
    int n_moodles = 0;
    const Found *other = NULL;
    for (int i = 0; i < folder->n_found; i++) {
        n_moodles += folder->found[i].name.is_moodles;
        other = folder->found[i].name.is_moodles ? other : &folder->found[i];
    }
    if (n_moodles > 0 && other != NULL) {
        char shown[ENTRY_NAME_BYTES];
        entry_name_show(other->file, strlen(other->file), shown);
        complain("gradebook: %s: not only Moodle's export, as \"%s\" is not: no two entries are "
                 "taken for one student's",
                 folder->path, shown);
    }
    return other == NULL;
}

// Only the host's export says that two entries are one student's: any other name is chosen by
// whoever hands in, and "ada-2" may be anybody's.
static int is_same_student(const Folder *folder, const Found *a, const Found *b)
{
    return folder->is_moodles && strcmp(a->name.name, b->name.name) == 0 &&
           strcmp(a->name.number, b->name.number) == 0;
}

// ---- The roster ------------------------------------------------------------------------------

// Two entries whose slugs collide, which somebody may try on purpose: the later gets a number.
static char *slug_new(const Roster *roster, const Found *found)
{
    char slug[ENTRY_SLUG_BYTES + 8];
    entry_name_slug(found->name.name, found->file, slug);
    const size_t length = strlen(slug);
    int n = 1;
    for (int i = 0; i < roster->n_entrants; i++) {
        if (strcmp(roster->entrants[i].slug, slug) == 0) {
            snprintf(slug + length, sizeof slug - length, "-%d", ++n);
            i = -1;
        }
    }
    return strdup(slug);
}

static int link_make(const char *submissions, const Found *found, const char *links,
                     const char *slug)
{
    char from[PATH_MAX], to[PATH_MAX];
    path_make(from, "%s/%s", submissions, found->file);
    path_make(to, "%s/%s", links, slug);
    if (symlink(from, to) != 0) {
        return fault(to, strerror(errno));
    }
    return 0;
}

// `submissions` is the folder's path from the root.
static int entrant_add(Roster *roster, const Folder *folder, const char *submissions,
                       const Found *found, int attempt, const char *links)
{
    char entry[ENTRY_NAME_BYTES];
    entry_name_show(found->file, strlen(found->file), entry);
    Entrant *entrant = &roster->entrants[roster->n_entrants];
    *entrant = (Entrant){.name = strdup(found->name.name),
                         .number = strdup(found->name.number),
                         .entry = strdup(entry),
                         .slug = slug_new(roster, found),
                         .attempt = attempt,
                         .is_exact = folder->is_moodles || found->submitters != NULL,
                         .is_link = found->is_link};
    roster->n_entrants++;
    const GradescopeEntry *submitters = found->submitters;
    entrant->n_members = submitters != NULL ? submitters->n_members : 0;
    if ((submitters != NULL &&
         members_copy(submitters->members, submitters->n_members, &entrant->members) != 0) ||
        entrant->name == NULL || entrant->number == NULL || entrant->entry == NULL ||
        entrant->slug == NULL) {
        return fault(submissions, "out of memory");
    }
    return found->is_link ? 0 : link_make(submissions, found, links, entrant->slug);
}

// From what was found, sorted by student, to entrants.
static int roster_fill(const Folder *folder, int only_latest, const char *links, Roster *roster)
{
    char path[PATH_MAX];
    roster->entrants = calloc((size_t)folder->n_found + 1, sizeof *roster->entrants);
    if (roster->entrants == NULL || realpath(folder->path, path) == NULL) {
        return fault(folder->path, strerror(errno));
    }
    int result = 0;
    int attempt = 1;
    for (int i = 0; result == 0 && i < folder->n_found; i++) {
        const Found *found = &folder->found[i];
        const int is_last =
            i + 1 == folder->n_found || !is_same_student(folder, found, &folder->found[i + 1]);
        if (is_last || !only_latest) {
            result = entrant_add(roster, folder, path, found, attempt, links);
        }
        attempt = is_last ? 1 : attempt + 1;
    }
    return result;
}

// A folder without links of an earlier run. What is no link is none of ours.
static int links_clear(const char *links)
{
    if (mkdir(links, 0755) != 0 && errno != EEXIST) {
        return fault(links, strerror(errno));
    }
    DIR *entries = opendir(links);
    if (entries == NULL) {
        return fault(links, strerror(errno));
    }
    struct dirent *entry;
    while ((entry = readdir(entries)) != NULL) {
        char target[1];
        if (readlinkat(dirfd(entries), entry->d_name, target, sizeof target) >= 0) {
            unlinkat(dirfd(entries), entry->d_name, 0);
        }
    }
    closedir(entries);
    return 0;
}

int roster_read(const char *submissions, int lab_number, int only_latest, const char *links,
                Roster *roster)
{
    Folder folder = {.path = submissions};
    *roster = (Roster){0};
    int result = folder_read(&folder, lab_number);
    if (result == 0 && folder.n_found == 0) {
        result = fault(submissions, "no submission: expected a folder or an archive for each "
                                    "student");
    }
    if (result == 0 && (result = names_apply(&folder)) == 0 && (result = links_clear(links)) == 0) {
        folder.is_moodles = is_moodles(&folder);
        qsort(folder.found, (size_t)folder.n_found, sizeof *folder.found, students_compare);
        result = roster_fill(&folder, only_latest, links, roster);
    }
    folder_free(&folder);
    return result;
}

void roster_free(Roster *roster)
{
    for (int i = 0; i < roster->n_entrants; i++) {
        Entrant *entrant = &roster->entrants[i];
        free(entrant->name), free(entrant->number), free(entrant->entry), free(entrant->slug);
        members_free(entrant->members, entrant->n_members);
    }
    free(roster->entrants);
    *roster = (Roster){0};
}
