// VPL, Moodle's laboratory of programs: a folder "Lovelace Ada 1234 ada" (see course_system.h).
#include "course_system.h"

// Two words at least before the number.
static SystemName read_vpl(const char *entry)
{
    NamePart parts[NAME_PARTS];
    SystemName name = {0};
    if (name_matches("^(.+ .*) ([0-9]+) ([^ ]+)$", entry, parts)) {
        name.system = SYSTEM_VPL;
        name.name = parts[1], name.number = parts[2], name.login = parts[3];
    }
    return name;
}

const CourseSystem vpl_system = {
    .title = "VPL",
    .identity = "the name of the student's folder",
    .identity_writer = WRITER_SYSTEM,
    .time = "none",
    .time_writer = WRITER_NOBODY,
    .read = read_vpl,
};
