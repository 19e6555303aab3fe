// Finding the time of an attempt (see entry_time.h).
#include "entry_time.h"

#include "evidence.h"
#include "path.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

enum { ILIAS_TIME_DIGITS = 14 };

// The folder of an ILIAS student, whose files ILIAS has named. Returns 0, or -1 for anything else.
static int ilias_folder(const Export *export, const Found *found, char path[PATH_MAX])
{
    if (found->name.system != SYSTEM_ILIAS || !found->is_folder ||
        !export_is_exact(export, found)) {
        return -1;
    }
    path_make(path, "%s/%s", export->path, found->file);
    return 0;
}

// The last time of the files in a folder of ILIAS's, which writes it whatever a student calls them.
// *is_late: one of them is marked.
static void ilias_look(const char *folder, char time[24], int *is_late)
{
    static const char *const marks[] = {"Late Submission - ", "Verspätete Abgabe - "};
    DIR *entries = opendir(folder);
    struct dirent *entry;
    while (entries != NULL && (entry = readdir(entries)) != NULL) {
        const char *name = entry->d_name;
        if (ilias_time_length(name) > 0 && strncmp(name, time, ILIAS_TIME_DIGITS) > 0) {
            snprintf(time, 24, "%.*s", ILIAS_TIME_DIGITS, name);
        }
        for (size_t m = 0; m < sizeof marks / sizeof *marks; m++) {
            *is_late |= strncmp(name, marks[m], strlen(marks[m])) == 0;
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
}

char *entry_time(const Export *export, const Found *found, ExportSystem *time_from)
{
    char path[PATH_MAX], time[24] = "";
    int is_late = 0;
    const char *text = found->submitters != NULL ? found->submitters->time : found->name.time;
    if (ilias_folder(export, found, path) == 0) {
        ilias_look(path, time, &is_late);
        text = time;
    }
    // Of Stud.IP's list the times are sure also where the owners are not.
    *time_from = found->is_listed                 ? SYSTEM_STUDIP
                 : export_is_exact(export, found) ? found->name.system
                                                  : SYSTEM_NONE;
    if (evidence_of(*time_from)->time_writer != WRITER_SYSTEM || text[0] == '\0') {
        *time_from = SYSTEM_NONE;
        text = "";
    }
    return strdup(text);
}

int entry_is_late(const Export *export, const Found *found)
{
    char path[PATH_MAX], time[24] = "";
    int is_late = export_is_exact(export, found) && found->name.is_late;
    if (ilias_folder(export, found, path) == 0) {
        ilias_look(path, time, &is_late);
    }
    return is_late;
}
