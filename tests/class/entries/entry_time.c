// Finding the time of an attempt (see entry_time.h).
#include "entry_time.h"

#include "course_system.h"
#include "export_read.h"
#include "ilias.h"
#include "path.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

// ---- ILIAS -------------------------------------------------------------------------------------

enum { ILIAS_TIME_DIGITS = 14 };

// What the names of the files in a student's folder say.
typedef struct IliasFiles {
    int n, n_timed;              // how many there are, and how many have a time before their name
    char time[24];               // the last of these, or ""
    int n_late;                  // how many are marked
    char odd[ENTRY_NAME_BYTES];  // one that may be, in a language that is not known here; or ""
} IliasFiles;

static void ilias_folder_look(const char *path, IliasFiles *files)
{
    struct dirent *entry;
    DIR *entries = opendir(path);
    while (entries != NULL && (entry = readdir(entries)) != NULL) {
        const char *name = entry->d_name;
        if (export_is_extra(name)) {
            continue;
        }
        files->n++;
        if (ilias_time_length(name) > 0) {
            files->n_timed++;
            if (strncmp(name, files->time, ILIAS_TIME_DIGITS) > 0) {
                snprintf(files->time, sizeof files->time, "%.*s", ILIAS_TIME_DIGITS, name);
            }
        } else if (ilias_is_marked(name)) {
            files->n_late++;
        } else if (ilias_may_be_marked(name)) {
            entry_name_show(name, strlen(name), files->odd);
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
}

// The folder of an ILIAS student, or that of a team with its members'? Then its files are looked
// at.
static int ilias_look(const Export *export, const Found *found, IliasFiles *files)
{
    char path[PATH_MAX], member[PATH_MAX];
    struct dirent *entry;
    *files = (IliasFiles){0};
    if (found->name.system != SYSTEM_ILIAS || !found->is_folder ||
        !export_is_exact(export, found)) {
        return 0;
    }
    path_make(path, "%s/%s", export->path, found->file);
    if (!found->is_team) {
        ilias_folder_look(path, files);
        return 1;
    }
    DIR *entries = opendir(path);
    while (entries != NULL && (entry = readdir(entries)) != NULL) {
        if (!export_is_extra(entry->d_name)) {
            path_make(member, "%s/%s", path, entry->d_name);
            ilias_folder_look(member, files);
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return 1;
}

static EntryTime ilias_time(const Export *export, const IliasFiles *files, int is_version)
{
    char words[ENTRY_NAME_BYTES + 100] = "";
    const int is_doubtful = is_version && files->n_late > 0 && files->n_late < files->n;
    EntryTime time = {.from = SYSTEM_ILIAS, .is_late = files->n_late > 0 && !is_doubtful};
    if (export->has_ilias_times && files->n_timed == files->n) {
        time.text = strdup(files->time);
        return time;
    }
    // A mark decides, but for a version of which not all files have it; without one there may be a
    // doubt.
    if (is_doubtful) {
        snprintf(words, sizeof words,
                 "ILIAS marked some of the student's files as late, and not all");
    } else if (!time.is_late && export->has_ilias_times) {
        snprintf(words, sizeof words, "not all of its files have a time, which ILIAS wrote here");
    } else if (!time.is_late && files->n_timed > 0) {
        snprintf(words, sizeof words,
                 "the name of a file begins with %s, which the student may have written",
                 files->time);
    } else if (!time.is_late && files->odd[0] != '\0') {
        snprintf(words, sizeof words,
                 "\"%s\" may begin with the mark of late work in a language that the grader does "
                 "not know",
                 files->odd);
    }
    time.from = words[0] != '\0' ? SYSTEM_NONE : SYSTEM_ILIAS;
    time.text = strdup(words);
    return time;
}

// ---- All ---------------------------------------------------------------------------------------

// Have the files of an attempt by Stud.IP's list the same time?
static int is_of_one_time(const Export *export, int begin, int end)
{
    int i = begin + 1;
    while (i < end && strcmp(export->found[i].listed_time, export->found[begin].listed_time) == 0) {
        i++;
    }
    return i >= end;
}

EntryTime entry_time(const Export *export, int begin, int end, int is_version)
{
    const Found *found = &export->found[begin];
    const char *text = found->submitters != NULL ? found->submitters->time : found->name.time;
    IliasFiles files;
    if (ilias_look(export, found, &files)) {
        return ilias_time(export, &files, is_version);
    }
    // Of Stud.IP's list the times are sure also where the owners are not.
    EntryTime time = {.from = found->is_listed                 ? SYSTEM_STUDIP
                              : export_is_exact(export, found) ? found->name.system
                                                               : SYSTEM_NONE};
    for (int i = begin; i < end && time.from != SYSTEM_NONE; i++) {
        time.is_late |= export->found[i].name.is_late;
    }
    if (time.from == SYSTEM_BRIGHTSPACE && text[0] == '\0') {
        text = "its name has two dates, or one in a form that the grader does not know";
        time.from = SYSTEM_NONE;
    } else if (time.from == SYSTEM_STUDIP && is_version && !is_of_one_time(export, begin, end)) {
        text = "the files of this name came at different times, which the list has";
        time.from = SYSTEM_NONE;
    } else if (time.from == SYSTEM_MOODLE) {
        text = "only Moodle's grading worksheet (LIST=) can say it";
        time.from = SYSTEM_NONE;
    } else if (course_system(time.from)->time_writer != WRITER_SYSTEM ||
               (text[0] == '\0' && !course_system(time.from)->has_marks)) {
        time.from = SYSTEM_NONE;
        text = "";
    }
    time.text = strdup(text);
    return time;
}
