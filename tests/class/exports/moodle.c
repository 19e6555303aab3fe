// Moodle: "Ada Lovelace_1234567_assignsubmission_file_" (see course_system.h).
#include "entry_name.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

// Moodle: "NAME_NUMBER_assignsubmission_KIND_...", and without a number for those who are in no
// team. Where the pattern stands twice, a student has put it into a name or a file's: then nobody
// can tell where the name ends. Returns the length of the name, or 0.
int moodle_name_read(const char *entry, EntryName *name)
{
    static const char pattern[] = "_assignsubmission_";
    const char *plugin = strstr(entry, pattern);
    name->system = plugin != NULL ? SYSTEM_MOODLE : SYSTEM_NONE;
    if (plugin == NULL || strstr(plugin + 1, pattern) != NULL) {
        return 0;
    }
    const char *digits = plugin;
    while (digits > entry && isdigit((unsigned char)digits[-1])) {
        digits--;
    }
    const int n_digits = (int)(plugin - digits);
    const int has_number =
        n_digits > 0 && n_digits < ENTRY_NUMBER_BYTES && digits > entry && digits[-1] == '_';
    const int length = (int)(has_number ? digits - 1 - entry : plugin - entry);
    if (length > 0) {
        snprintf(name->number, sizeof name->number, "%.*s", has_number ? n_digits : 0, digits);
        name->is_text = strncmp(plugin, "_assignsubmission_onlinetext", 28) == 0;
        const char *file = strchr(plugin + strlen(pattern), '_');
        name->file = file != NULL && file[1] != '\0' ? (int)(file + 1 - entry) : 0;
    }
    return length;
}

static int is_possible(const char *entry)
{
    NamePart parts[NAME_PARTS];
    return name_matches("^.+_assignsubmission_", entry, parts);
}

const CourseSystem moodle_system = {
    .title = "Moodle",
    .identity = "the name and the number before `_assignsubmission_`",
    .identity_writer = WRITER_SYSTEM,
    .time = "the worksheet's column *Last modified (submission)*",
    .time_writer = WRITER_SYSTEM,
    .is_possible = is_possible,
};
