// The table of course systems (see course_system.h). Read next: canvas.c; entry_name.c.
#include "course_system.h"

#include <regex.h>
#include <stdlib.h>
#include <string.h>

static const CourseSystem plain_names = {
    .title = "a plain name",
    .identity = "the name of the folder or archive",
    .identity_writer = WRITER_STUDENT,
    .time = "none",
    .time_writer = WRITER_NOBODY,
};
static const CourseSystem own_words = {
    .title = "your own",
    .identity = "`WHO=`",
    .identity_writer = WRITER_INSTRUCTOR,
    .time = "the column `handed in` of your `LIST=` or `WHO=`",
    .time_writer = WRITER_INSTRUCTOR,
};

const CourseSystem *course_system(ExportSystem system)
{
    static const CourseSystem *const systems[N_SYSTEMS] = {
        [SYSTEM_NONE] = &plain_names,
        [SYSTEM_MOODLE] = &moodle_system,
        [SYSTEM_CANVAS] = &canvas_system,
        [SYSTEM_BLACKBOARD] = &blackboard_system,
        [SYSTEM_BRIGHTSPACE] = &brightspace_system,
        [SYSTEM_ILIAS] = &ilias_system,
        [SYSTEM_VPL] = &vpl_system,
        [SYSTEM_STUDIP] = &studip_system,
        [SYSTEM_GRADESCOPE] = &gradescope_system,
        [SYSTEM_GIT] = &git_system,
        [SYSTEM_OWN] = &own_words,
    };
    return systems[system];
}

ExportSystem course_system_find(const char *title)
{
    ExportSystem system = N_SYSTEMS - 1;
    while (system > SYSTEM_NONE && strcmp(title, course_system(system)->title) != 0) {
        system--;
    }
    return system;
}

const char *writer_words(Writer writer)
{
    static const char *const words[] = {[WRITER_NOBODY] = "–",
                                        [WRITER_STUDENT] = "a student",
                                        [WRITER_SYSTEM] = "the system",
                                        [WRITER_INSTRUCTOR] = "you"};
    return words[writer];
}

SystemName system_name_read(const char *entry, ExportSystem system)
{
    const CourseSystem *of = course_system(system);
    return of->read != NULL ? of->read(entry) : (SystemName){0};
}

int system_name_is_possible(const char *entry, ExportSystem system)
{
    const CourseSystem *of = course_system(system);
    return of->is_possible != NULL ? of->is_possible(entry)
                                   : system_name_read(entry, system).system == system;
}

// Does a text match? The parts of the groups, the whole being the first.
int name_matches(const char *pattern, const char *text, NamePart parts[NAME_PARTS])
{
    regex_t compiled;
    regmatch_t found[NAME_PARTS];
    if (regcomp(&compiled, pattern, REG_EXTENDED) != 0) {
        abort();  // the patterns are ours
    }
    const int is_match = regexec(&compiled, text, NAME_PARTS, found, 0) == 0;
    for (int i = 0; is_match && i < NAME_PARTS; i++) {
        parts[i] = found[i].rm_so < 0 ? (NamePart){text, 0}
                                      : (NamePart){text + found[i].rm_so,
                                                   (size_t)(found[i].rm_eo - found[i].rm_so)};
    }
    regfree(&compiled);
    return is_match;
}
