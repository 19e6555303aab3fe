// Finding the time of an attempt (see entry_time.h).
#include "entry_time.h"

#include "path.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

enum { ILIAS_TIME_DIGITS = 14, MOST_FILES = 1000 };

// The last time of the files in a folder of ILIAS's. It writes the times, whatever a student calls
// the files.
static void ilias_last(const char *folder, char time[24])
{
    DIR *entries = opendir(folder);
    struct dirent *entry;
    for (int i = 0; entries != NULL && i < MOST_FILES && (entry = readdir(entries)) != NULL; i++) {
        if (ilias_time_length(entry->d_name) > 0 &&
            strncmp(entry->d_name, time, ILIAS_TIME_DIGITS) > 0) {
            snprintf(time, 24, "%.*s", ILIAS_TIME_DIGITS, entry->d_name);
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
}

char *entry_time(const Export *export, const Found *found)
{
    char path[PATH_MAX], time[24] = "";
    if (found->submitters != NULL) {
        return strdup(found->submitters->time);
    }
    if (found->name.system == SYSTEM_ILIAS && found->is_folder && export_is_exact(export, found)) {
        path_make(path, "%s/%s", export->path, found->file);
        ilias_last(path, time);
        return strdup(time);
    }
    return strdup(export_is_exact(export, found) ? found->name.time : "");
}
