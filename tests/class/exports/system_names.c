// The patterns of system_names.h, as regular expressions. Read next: entry_name.c.
#include "system_names.h"

#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_GROUPS = 8 };

// Does a text match? The parts of the groups, the whole being the first.
static int matches(const char *pattern, const char *text, NamePart parts[MOST_GROUPS])
{
    regex_t compiled;
    regmatch_t found[MOST_GROUPS];
    if (regcomp(&compiled, pattern, REG_EXTENDED) != 0) {
        abort();  // the patterns are ours
    }
    const int is_match = regexec(&compiled, text, MOST_GROUPS, found, 0) == 0;
    for (int i = 0; is_match && i < MOST_GROUPS; i++) {
        parts[i] = found[i].rm_so < 0 ? (NamePart){text, 0}
                                      : (NamePart){text + found[i].rm_so,
                                                   (size_t)(found[i].rm_eo - found[i].rm_so)};
    }
    regfree(&compiled);
    return is_match;
}

static SystemName read_canvas(const char *entry)
{
    static const char late[] = "_LATE";
    NamePart parts[MOST_GROUPS], more[MOST_GROUPS];
    SystemName name = {0};
    // A name may have underscores, but no number between two: the first ones are Canvas'.
    const int is_named = matches("_([0-9]+)_([0-9]+)_(.+)$", entry, parts) ||
                         matches("_([0-9]+)_()((text|link)\\.html)$", entry, parts);
    // Names are in small letters: only a file's own name may have what looks like another mark, and
    // then it was meant so.
    const int is_late = matches("_LATE_[0-9]+_([0-9]+_|(text|link)\\.html)", entry, more) ||
                        matches("^LATE_anon_", entry, more);
    // Where submissions are anonymous.
    const int is_anonymous =
        matches("^(LATE_)?(anon_[A-Za-z0-9]{5})_[0-9]+_(.+)$", entry, more) ||
        matches("^(LATE_)?(anon_[A-Za-z0-9]{5})_((text|link)\\.html)$", entry, more);
    if (is_anonymous && !(is_named && parts[0].text < more[2].text + more[2].length)) {
        name.system = SYSTEM_CANVAS;
        name.name = more[2], name.file = more[3];
        name.is_late = is_late;
        return name;
    }
    size_t n_name = is_named ? (size_t)(parts[0].text - entry) : 0;
    if (n_name >= strlen(late) && strncmp(entry + n_name - strlen(late), late, strlen(late)) == 0) {
        n_name -= strlen(late);
    }
    // "group_a_03_40012_file" is somebody's own way to name files: few people have underscores in
    // their names, and few of Canvas' numbers are so short.
    enum { LEAST_DIGITS = 3 };
    if (memchr(entry, '_', n_name) != NULL &&
        (parts[1].length < LEAST_DIGITS ||
         (parts[2].length > 0 && parts[2].length < LEAST_DIGITS))) {
        return name;
    }
    // A third number, or two more further back: nobody can tell which of them are Canvas' and which
    // are in a name that the student chose. So the file is nobody's, also where another student's
    // number is in it.
    if (n_name == 0 ||
        matches("^[0-9]+_|_[0-9]{3,}_([0-9]{3,}_|(text|link)\\.html$)", parts[3].text, more)) {
        return name;
    }
    name.system = SYSTEM_CANVAS;
    name.name = (NamePart){entry, n_name};
    name.number = parts[1], name.login = parts[1], name.file = parts[3];
    name.is_late = is_late;
    return name;
}

static SystemName read_blackboard(const char *entry)
{
    static const char word[] = "_attempt_";
    NamePart parts[MOST_GROUPS];
    SystemName name = {0};
    for (const char *at = strstr(entry, word); at != NULL; at = strstr(at + 1, word)) {
        if (at == entry ||
            !matches("^([0-9]{4}(-[0-9]{2}){5})(_(.+)|\\.txt)$", at + strlen(word), parts)) {
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
    NamePart head[MOST_GROUPS], parts[MOST_GROUPS];
    SystemName name = {0};
    if (!matches("^([0-9]+)-[0-9]+ - (.)", entry, head)) {
        return name;
    }
    const char *begin = head[2].text;
    for (const char *at = strstr(begin, " - "); at != NULL; at = strstr(at + 1, " - ")) {
        if (at == begin || !matches("^(([A-Z][a-z]+ [0-9]{1,2}|[0-9]{1,2} [A-Z][a-z]+), [0-9]{4} "
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

static SystemName read_ilias(const char *entry)
{
    NamePart parts[MOST_GROUPS];
    SystemName name = {0};
    if (matches("^(.+)_([^_]+)_([0-9]+)$", entry, parts)) {
        name.system = SYSTEM_ILIAS;
        name.name = parts[1], name.login = parts[2], name.number = parts[3];
    }
    return name;
}

// Two words at least before the number.
static SystemName read_vpl(const char *entry)
{
    NamePart parts[MOST_GROUPS];
    SystemName name = {0};
    if (matches("^(.+ .*) ([0-9]+) ([^ ]+)$", entry, parts)) {
        name.system = SYSTEM_VPL;
        name.name = parts[1], name.number = parts[2], name.login = parts[3];
    }
    return name;
}

SystemName system_name_read(const char *entry, ExportSystem system)
{
    typedef SystemName Reader(const char *entry);
    static Reader *const readers[N_SYSTEMS] = {[SYSTEM_CANVAS] = read_canvas,
                                               [SYSTEM_BLACKBOARD] = read_blackboard,
                                               [SYSTEM_BRIGHTSPACE] = read_brightspace,
                                               [SYSTEM_ILIAS] = read_ilias,
                                               [SYSTEM_VPL] = read_vpl};
    return readers[system] != NULL ? readers[system](entry) : (SystemName){0};
}

int system_name_is_possible(const char *entry, ExportSystem system)
{
    NamePart parts[MOST_GROUPS];
    switch (system) {
    case SYSTEM_MOODLE:
        return matches("^.+_assignsubmission_", entry, parts);
    case SYSTEM_CANVAS:
        return matches("^.+_[0-9]+_([0-9]+_.|(text|link)\\.html$)", entry, parts);
    default:
        return system_name_read(entry, system).system == system;
    }
}

int ilias_name_is_whole(const char *entry)
{
    NamePart parts[MOST_GROUPS];
    return matches("^.+_.*_[^_]+_[0-9]+$", entry, parts);
}

size_t ilias_time_length(const char *file)
{
    NamePart parts[MOST_GROUPS];
    return matches("^([0-9]{14}_[0-9]+_).", file, parts) ? parts[1].length : 0;
}
