// From a folder of submissions to rows (see roster.h).
//
// The links spare the driver, a shell script, every name that somebody else chose. Read next:
// export.h, loose_files.h, grade_class.sh.
#include "roster.h"

#include "entry_time.h"
#include "export_read.h"
#include "file_names.h"
#include "folder.h"
#include "loose_files.h"
#include "path.h"
#include "sheet.h"
#include "versions.h"

#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// ---- The roster ------------------------------------------------------------------------------

// Two entries whose slugs collide, which somebody may try on purpose: the later gets a number.
static char *slug_new(const Roster *roster, const char *name, const char *entry)
{
    char slug[ENTRY_SLUG_BYTES + 8];
    entry_name_slug(name, entry, slug);
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
typedef struct Targets {
    const char *links;                                // the folder of links
    char submissions[PATH_MAX], collected[PATH_MAX];  // their targets, as paths from the root
} Targets;

static int link_make(const char *target, const char *name, const char *links, const char *slug)
{
    char from[PATH_MAX], to[PATH_MAX];
    path_make(from, "%s/%s", target, name);
    path_make(to, "%s/%s", links, slug);
    return symlink(from, to) == 0 ? 0 : path_fault(to, strerror(errno));
}

// Those of a team of ILIAS' who have uploaded: their folders are in the team's. Returns 0, or -1
// when memory runs out.
static int team_make(const Export *export, const Found *found, Entrant *entrant)
{
    char path[PATH_MAX], none[] = "";
    path_make(path, "%s/%s", export->path, found->file);
    struct dirent **entries = NULL;
    const int n = scandir(path, &entries, NULL, alphasort);
    int failed = 0;
    for (int i = 0; i < n; i++) {
        const EntryName name = entry_name_read_export(entries[i]->d_name, 1, SYSTEM_ILIAS);
        if (!failed && name.system == SYSTEM_ILIAS) {
            const Member member = {(char *)name.name, none, none, (char *)name.login};
            failed = member_add(&entrant->members, &entrant->n_members, member) != 0;
        }
        free(entries[i]);
    }
    free(entries);
    entrant->is_team = 1;
    return failed || n < 0 ? -1 : 0;
}

// Who handed an attempt in, where the export says more than a name. Returns 0, or -1 when memory
// runs out.
static int members_make(const Export *export, const Found *found, Entrant *entrant)
{
    char none[] = "";
    char *name = entrant->name, *login = (char *)found->name.login;
    const Member member = {name, none, none, login};
    if (export_is_exact(export, found) && found->is_team) {
        return team_make(export, found, entrant);
    }
    if (found->submitters != NULL) {
        entrant->n_members = found->submitters->n_members;
        return members_copy(found->submitters->members, entrant->n_members, &entrant->members);
    }
    entrant->n_members = login[0] != '\0' && export_is_exact(export, found);
    return members_copy(&member, entrant->n_members, &entrant->members);
}

// What is handed in at a time: the entries from `begin` to before `end`.
typedef struct Attempt {
    const Export *export;
    const Manifest *manifest;
    const Targets *places;
    int begin, end;
    int number;  // 1, 2 ... of one student's
} Attempt;

// Add an entrant for an attempt, or for a version of it, without a link. `entry`: what it is
// called. Returns it, or NULL when memory runs out.
static Entrant *entrant_add(Roster *roster, const Attempt *attempt, const char *entry, int version)
{
    const Export *export = attempt->export;
    const Found *found = &export->found[attempt->begin];
    char shown[ENTRY_NAME_BYTES];
    Entrant *entrants = array_grown(roster->entrants, roster->n_entrants, sizeof *entrants);
    if (entrants == NULL) {
        return NULL;
    }
    roster->entrants = entrants;
    Entrant *entrant = &entrants[roster->n_entrants];
    entry_name_show(entry, strlen(entry), shown);
    const EntryTime time = entry_time(export, attempt->begin, attempt->end, version > 0);
    *entrant = (Entrant){.name = strdup(found->name.name),
                         .time = time.text,
                         .time_from = time.from,
                         .is_late = time.is_late,
                         .number = strdup(found->name.number),
                         .entry = strdup(shown),
                         .slug = slug_new(roster, found->name.name, entry),
                         .attempt = attempt->number,
                         .version = version,
                         .is_exact = export_is_exact(export, found),
                         .is_link = found->is_link};
    roster->n_entrants++;
    return entrant->name != NULL && entrant->number != NULL && entrant->entry != NULL &&
                   entrant->time != NULL && entrant->slug != NULL &&
                   members_make(export, found, entrant) == 0
               ? entrant
               : NULL;
}

// What a version is called: the file of a flat export, or the student's folder and the file in it.
static void version_name(const Attempt *attempt, const Place *place, char name[PATH_MAX])
{
    const Found *found = &attempt->export->found[attempt->begin];
    for (int i = attempt->begin; found->is_loose && i < attempt->end; i++) {
        char own[NAME_MAX + 1];
        loose_file_name(attempt->export, attempt->begin, attempt->end, i, own);
        if (!attempt->export->found[i].is_folder && strcmp(own, place->name) == 0) {
            path_make(name, "%s", attempt->export->found[i].file);
            return;
        }
    }
    path_make(name, "%s/%s%s%s", found->file, place->folder, place->folder[0] != '\0' ? "/" : "",
              place->name);
}

// What an attempt is called: of Stud.IP's by all its files, as they may be those of two of one
// name.
static void attempt_name(const Attempt *attempt, char name[ENTRY_NAME_BYTES])
{
    const Found *found = &attempt->export->found[attempt->begin];
    size_t length = (size_t)snprintf(name, ENTRY_NAME_BYTES, "%s", found->file);
    for (int i = attempt->begin + 1; found->name.system == SYSTEM_STUDIP && i < attempt->end; i++) {
        const char *file = attempt->export->found[i].file;
        if (length + strlen(file) + sizeof " + ..." > ENTRY_NAME_BYTES) {
            snprintf(name + length, ENTRY_NAME_BYTES - length, " ...");
            return;
        }
        length += (size_t)snprintf(name + length, ENTRY_NAME_BYTES - length, " + %s", file);
    }
}

// Add an entrant for each version of an attempt, with a folder of its own. `from`: where the
// attempt is. Returns 0, or -1 after one message.
static int versions_add(Roster *roster, const Attempt *attempt, const Versions *versions,
                        const char *from)
{
    int result = 0;
    for (int i = 0; result == 0 && i < versions->n; i++) {
        char name[PATH_MAX], folder[PATH_MAX];
        version_name(attempt, version_place(versions, i), name);
        const Entrant *entrant = entrant_add(roster, attempt, name, i + 1);
        if (entrant == NULL) {
            return path_fault(attempt->export->path, "out of memory");
        }
        path_make(folder, "%s/%s", attempt->places->collected, entrant->slug);
        result = version_collect(from, attempt->manifest, versions, i, folder) == 0
                     ? link_make(attempt->places->collected, entrant->slug, attempt->places->links,
                                 entrant->slug)
                     : -1;
    }
    return result;
}

// Are the numbers that the system has put behind names those of later uploads? Canvas' are.
static int is_numbered_by_time(const Attempt *attempt, const Versions *versions)
{
    return attempt->export->found[attempt->begin].name.system == SYSTEM_CANVAS &&
           export_is_exact(attempt->export, &attempt->export->found[attempt->begin]) &&
           name_upload_number(version_place(versions, 0)->name) > 0;
}

// Add an attempt: an entrant with a link to its folder or archive, or to a new folder with its
// single files; or one for each version of a file. Returns 0, or -1 after one message.
static int attempt_add(Roster *roster, const Attempt *attempt)
{
    const Found *found = &attempt->export->found[attempt->begin];
    const Targets *places = attempt->places;
    char from[PATH_MAX];
    Versions versions = {0};
    if (found->is_loose) {
        path_make(from, "%s/new", places->collected);
        if (loose_files_collect(attempt->export, attempt->begin, attempt->end, attempt->manifest,
                                from) != 0) {
            return -1;
        }
    } else {
        path_make(from, "%s/%s", places->submissions, found->file);
    }
    if ((found->is_loose || found->is_folder) && attempt->manifest->n_files > 0 &&
        versions_find(from, attempt->manifest, &versions) != 0) {
        return -1;
    }
    int result;
    if (versions.n > 1 && !is_numbered_by_time(attempt, &versions)) {
        result = versions_add(roster, attempt, &versions, from);
        if (result == 0 && found->is_loose) {
            result = folder_remove(from) == 0 ? 0 : path_fault(from, strerror(errno));
        }
    } else {
        char name[ENTRY_NAME_BYTES];
        attempt_name(attempt, name);
        const Entrant *entrant = entrant_add(roster, attempt, name, 0);
        result = entrant != NULL ? 0 : path_fault(attempt->export->path, "out of memory");
        if (result == 0 && found->is_loose) {
            char folder[PATH_MAX];
            path_make(folder, "%s/%s", places->collected, entrant->slug);
            result = rename(from, folder) == 0 ? 0 : path_fault(folder, strerror(errno));
        }
        if (result == 0 && !found->is_link) {
            result = link_make(found->is_loose ? places->collected : places->submissions,
                               found->is_loose ? entrant->slug : found->file, places->links,
                               entrant->slug);
        }
    }
    versions_free(&versions);
    return result;
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
static int roster_fill(const Export *export, const Manifest *manifest, int only_latest,
                       const Targets *places, Roster *roster)
{
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
            result = attempt_add(roster, &(Attempt){export, manifest, places, i, end, attempt});
        }
        attempt = is_last ? 1 : attempt + 1;
    }
    for (int i = 0; result == 0 && i < roster->n_entrants; i++) {
        if (label_make(roster, &roster->entrants[i]) != 0) {
            result = path_fault(export->path, "out of memory");
        }
    }
    return result;
}

// An empty folder for single files, in place of that of an earlier run.
static int collected_clear(const char *collected)
{
    if ((folder_remove(collected) != 0 && errno != ENOENT) || mkdir(collected, 0700) != 0) {
        return path_fault(collected, strerror(errno));
    }
    return 0;
}

// A folder without links of an earlier run. What is no link is none of ours.
static int links_clear(const char *links)
{
    if (mkdir(links, 0755) != 0 && errno != EEXIST) {
        return path_fault(links, strerror(errno));
    }
    DIR *entries = opendir(links);
    if (entries == NULL) {
        return path_fault(links, strerror(errno));
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

int roster_read(const char *submissions, int lab_number, const Manifest *manifest, int only_latest,
                const char *folder, Roster *roster)
{
    Export export;
    Targets places;
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
        result = path_fault(submissions, "no submission: expected a folder or an archive for each "
                                         "student, or files that a course system has named");
    }
    if (result == 0 &&
        (realpath(export.path, places.submissions) == NULL || realpath(folder, root) == NULL)) {
        result = path_fault(submissions, strerror(errno));
    }
    if (result == 0) {
        path_make(places.collected, "%s/collected", root);
        result = links_clear(links) != 0 || collected_clear(places.collected) != 0 ? -1 : 0;
    }
    if (result == 0) {
        result = roster_fill(&export, manifest, only_latest, &places, roster);
        roster->passed_over = export.passed_over, roster->n_passed_over = export.n_passed_over;
        export.passed_over = NULL, export.n_passed_over = 0;
    }
    export_free(&export);
    return result;
}

void roster_free(Roster *roster)
{
    const int is_own = roster->json == NULL;
    for (int i = 0; i < roster->n_entrants; i++) {
        Entrant *entrant = &roster->entrants[i];
        if (is_own) {
            free(entrant->name), free(entrant->label), free(entrant->number);
            free(entrant->entry), free(entrant->slug), free(entrant->time);
        }
        members_free(entrant->members, is_own ? entrant->n_members : 0);
    }
    for (int i = 0; is_own && i < roster->n_passed_over; i++) {
        free(roster->passed_over[i]);
    }
    free(roster->entrants), free(roster->passed_over);
    json_decref(roster->json);
    *roster = (Roster){0};
}
