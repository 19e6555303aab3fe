// Blackboard: "Lab 0_ab12_attempt_2026-11-03-10-22-33_file.cl" (see course_system.h).
#include "course_system.h"

#include <stdio.h>
#include <string.h>

static SystemName read_blackboard(const char *entry)
{
    static const char word[] = "_attempt_";
    NamePart parts[NAME_PARTS];
    SystemName name = {0};
    for (const char *at = strstr(entry, word); at != NULL; at = strstr(at + 1, word)) {
        if (at == entry ||
            !name_matches("^([0-9]{4}(-[0-9]{2}){5})(_(.+)|\\.txt)$", at + strlen(word), parts)) {
            continue;
        }
        const char *login = at;
        while (login > entry && login[-1] != '_') {
            login--;
        }
        if (login == at) {
            break;
        }
        name.system = SYSTEM_BLACKBOARD;
        name.name = (NamePart){login, (size_t)(at - login)};
        name.is_note = parts[4].length == 0;
        name.file = name.is_note ? (NamePart){parts[3].text + 1, parts[3].length - 1} : parts[4];
        snprintf(name.time, sizeof name.time, "%.*s", (int)parts[1].length, parts[1].text);
        break;
    }
    return name;
}

const CourseSystem blackboard_system = {
    .title = "Blackboard",
    .identity = "the login before `_attempt_`",
    .identity_writer = WRITER_SYSTEM,
    .time = "the names of the files",
    .time_writer = WRITER_SYSTEM,
    .read = read_blackboard,
};
