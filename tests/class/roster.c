// From a folder of submissions to rows (see roster.h).
//
// The links spare the driver, a shell script, every name that somebody else chose. Read next:
// export.h, loose_files.h, grade_class.sh.
#include "roster.h"

#include "complain.h"
#include "entry_time.h"
#include "export.h"
#include "folder.h"
#include "loose_files.h"
#include "path.h"

#include <dirent.h>
#include <errno.h>
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

// Where the driver's files lead to.
typedef struct Places {
    const char *links;                                // the folder of links
    char submissions[PATH_MAX], collected[PATH_MAX];  // their targets, as paths from the root
} Places;

static int link_make(const char *target, const char *name, const char *links, const char *slug)
{
    char from[PATH_MAX], to[PATH_MAX];
    path_make(from, "%s/%s", target, name);
    path_make(to, "%s/%s", links, slug);
    return symlink(from, to) == 0 ? 0 : fault(to, strerror(errno));
}

// A link to an attempt: to its folder or archive, or to a new folder with its single files.
static int attempt_link(const Export *export, int begin, int end, const Places *places,
                        const char *slug)
{
    char folder[PATH_MAX];
    const Found *found = &export->found[begin];
    if (!found->is_loose) {
        return link_make(places->submissions, found->file, places->links, slug);
    }
    path_make(folder, "%s/%s", places->collected, slug);
    return loose_files_collect(export, begin, end, folder) == 0
               ? link_make(places->collected, slug, places->links, slug)
               : -1;
}

// Who handed an attempt in, where the export says more than a name. Returns 0, or -1 when memory
// runs out.
static int members_make(const Export *export, const Found *found, Entrant *entrant)
{
    char none[] = "";
    char *name = entrant->name, *login = (char *)found->name.login;
    const Member member = {name, none, none, login};
    if (found->submitters != NULL) {
        entrant->n_members = found->submitters->n_members;
        return members_copy(found->submitters->members, entrant->n_members, &entrant->members);
    }
    entrant->n_members = login[0] != '\0' && export_is_exact(export, found);
    return members_copy(&member, entrant->n_members, &entrant->members);
}

static int entrant_add(Roster *roster, const Export *export, int begin, int end, int attempt,
                       const Places *places)
{
    char entry[ENTRY_NAME_BYTES];
    const Found *found = &export->found[begin];
    entry_name_show(found->file, strlen(found->file), entry);
    Entrant *entrant = &roster->entrants[roster->n_entrants];
    const EntryTime time = entry_time(export, begin, end);
    *entrant = (Entrant){.name = strdup(found->name.name),
                         .time = time.text,
                         .time_from = time.from,
                         .is_late = time.is_late,
                         .number = strdup(found->name.number),
                         .entry = strdup(entry),
                         .slug = slug_new(roster, found),
                         .attempt = attempt,
                         .is_exact = export_is_exact(export, found),
                         .is_link = found->is_link};
    roster->n_entrants++;
    if (entrant->name == NULL || entrant->number == NULL || entrant->entry == NULL ||
        entrant->time == NULL || entrant->slug == NULL ||
        members_make(export, found, entrant) != 0) {
        return fault(export->path, "out of memory");
    }
    return found->is_link ? 0 : attempt_link(export, begin, end, places, entrant->slug);
}

// Blackboard writes a text about each attempt. Is this one's beside what was handed in then?
static int is_only_about(const Export *export, int begin, int end)
{
    const Found *found = &export->found[begin];
    return found->name.system == SYSTEM_BLACKBOARD && found->name.is_text &&
           end < export->n_found && export_is_same_student(export, found, &export->found[end]) &&
           strcmp(found->name.time, export->found[end].name.time) == 0;
}

// What tells an entrant from others of the same name: a number, or else the entry's own name. Of
// one student's attempts it is nothing. Returns 0, or -1 when memory runs out.
static int label_make(const Roster *roster, Entrant *entrant)
{
    const char *apart = "";
    for (int i = 0; i < roster->n_entrants; i++) {
        const Entrant *other = &roster->entrants[i];
        if (other == entrant || strcmp(other->name, entrant->name) != 0) {
            continue;
        }
        if (strcmp(other->number, entrant->number) != 0 && entrant->number[0] != '\0') {
            apart = entrant->number;
        } else if (other->attempt == entrant->attempt &&
                   strcmp(entrant->entry, entrant->name) != 0) {
            apart = entrant->entry;
        }
    }
    const int is_alone = apart[0] == '\0';
    return asprintf(&entrant->label, "%s%s%s%s", entrant->name, is_alone ? "" : " (", apart,
                    is_alone ? "" : ")") < 0
               ? -1
               : 0;
}

// From what was found, sorted by student, to entrants.
static int roster_fill(const Export *export, int only_latest, const Places *places, Roster *roster)
{
    roster->entrants = calloc((size_t)export->n_found + 1, sizeof *roster->entrants);
    if (roster->entrants == NULL) {
        return fault(export->path, "out of memory");
    }
    int result = 0;
    int attempt = 1;
    for (int i = 0, end; result == 0 && i < export->n_found; i = end) {
        end = export_attempt_end(export, i);
        if (is_only_about(export, i, end)) {
            continue;
        }
        const int is_last = end == export->n_found ||
                            !export_is_same_student(export, &export->found[i], &export->found[end]);
        if (is_last || !only_latest) {
            result = entrant_add(roster, export, i, end, attempt, places);
        }
        attempt = is_last ? 1 : attempt + 1;
    }
    for (int i = 0; result == 0 && i < roster->n_entrants; i++) {
        if (label_make(roster, &roster->entrants[i]) != 0) {
            result = fault(export->path, "out of memory");
        }
    }
    return result;
}

// An empty folder for single files, in place of that of an earlier run.
static int collected_clear(const char *collected)
{
    if ((folder_remove(collected) != 0 && errno != ENOENT) || mkdir(collected, 0700) != 0) {
        return fault(collected, strerror(errno));
    }
    return 0;
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

int roster_read(const char *submissions, int lab_number, int only_latest, const char *folder,
                Roster *roster)
{
    Export export;
    Places places;
    char links[PATH_MAX], root[PATH_MAX];
    *roster = (Roster){0};
    path_make(links, "%s/submissions", folder);
    places.links = links;
    // Submissions are nowhere in the class's own folder, but for what was unpacked there.
    const size_t n_folder = strlen(folder);
    const int is_unpacked =
        strncmp(submissions, folder, n_folder) == 0 && submissions[n_folder] == '/';
    int result = export_read(submissions, is_unpacked, lab_number, &export);
    if (result == 0 && export.n_found == 0) {
        result = fault(submissions, "no submission: expected a folder or an archive for each "
                                    "student, or files that a course system has named");
    }
    if (result == 0 &&
        (realpath(export.path, places.submissions) == NULL || realpath(folder, root) == NULL)) {
        result = fault(submissions, strerror(errno));
    }
    if (result == 0) {
        path_make(places.collected, "%s/collected", root);
        result = links_clear(links) != 0 || collected_clear(places.collected) != 0 ? -1 : 0;
    }
    if (result == 0) {
        entry_times_settle(&export);
        result = roster_fill(&export, only_latest, &places, roster);
        roster->passed_over = export.passed_over, roster->n_passed_over = export.n_passed_over;
        export.passed_over = NULL, export.n_passed_over = 0;
    }
    export_free(&export);
    return result;
}

void roster_free(Roster *roster)
{
    for (int i = 0; i < roster->n_entrants; i++) {
        Entrant *entrant = &roster->entrants[i];
        free(entrant->name), free(entrant->label), free(entrant->number), free(entrant->entry),
            free(entrant->slug), free(entrant->time);
        members_free(entrant->members, entrant->n_members);
    }
    for (int i = 0; i < roster->n_passed_over; i++) {
        free(roster->passed_over[i]);
    }
    free(roster->entrants), free(roster->passed_over);
    *roster = (Roster){0};
}
