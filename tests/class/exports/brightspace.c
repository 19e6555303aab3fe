// Brightspace (D2L): "40012-880036 - Ada Lovelace - Nov 3, 2026 1022 AM - file.cl" (see
// course_system.h).
#include "course_system.h"

#include <stdio.h>
#include <string.h>

// "Nov 3, 2026 1022 AM" as a time that can be sorted; months by their first three letters.
static void time_read(NamePart part, char time[24])
{
    static const char months[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
    char text[64], month[16], half[3] = "";
    int day, year, clock;
    snprintf(text, sizeof text, "%.*s", (int)part.length, part.text);
    if (sscanf(text, "%15[A-Za-z] %d, %d %d %2s", month, &day, &year, &clock, half) < 4 &&
        sscanf(text, "%d %15[A-Za-z], %d %d %2s", &day, month, &year, &clock, half) < 4) {
        return;
    }
    month[3] = '\0';
    const char *at = strstr(months, month);
    if (at == NULL || (at - months) % 3 != 0) {
        return;  // another language's
    }
    const int hour = clock / 100 % 12 + (half[0] == 'P' ? 12 : 0);
    const int n_month = (int)(at - months) / 3 + 1;
    snprintf(time, 24, "%04u-%02u-%02u-%02u-%02u", (unsigned)year % 10000, (unsigned)n_month % 100,
             (unsigned)day % 100, (unsigned)(half[0] != '\0' ? hour : clock / 100) % 100,
             (unsigned)clock % 100);
}

static SystemName read_brightspace(const char *entry)
{
    NamePart head[NAME_PARTS], parts[NAME_PARTS];
    SystemName name = {0};
    if (!name_matches("^([0-9]+)-[0-9]+ - (.)", entry, head)) {
        return name;
    }
    const char *begin = head[2].text;
    for (const char *at = strstr(begin, " - "); at != NULL; at = strstr(at + 1, " - ")) {
        if (at == begin ||
            !name_matches("^(([A-Z][a-z]+ [0-9]{1,2}|[0-9]{1,2} [A-Z][a-z]+), [0-9]{4} "
                          "[0-9]{3,4}( [AP]M)?)( - (.+))?$",
                          at + 3, parts)) {
            continue;
        }
        // Of two times the one that ends a folder's name is Brightspace's. Before a file's name
        // either may be part of a name that somebody chose, also where the other one has a form
        // that is not known here.
        if (name.system == SYSTEM_BRIGHTSPACE && parts[5].length > 0) {
            name.time[0] = '\0';
            break;
        }
        name.system = SYSTEM_BRIGHTSPACE;
        name.name = (NamePart){begin, (size_t)(at - begin)};
        name.number = head[1], name.login = head[1], name.file = parts[5];
        if (name.file.length == 0 || memmem(begin, name.name.length, " - ", 3) == NULL) {
            time_read(parts[1], name.time);
        }
    }
    return name;
}

const CourseSystem brightspace_system = {
    .title = "Brightspace",
    .identity = "the number and the name before the name of each file",
    .identity_writer = WRITER_SYSTEM,
    .time = "the names of the files",
    .time_writer = WRITER_SYSTEM,
    .read = read_brightspace,
};
