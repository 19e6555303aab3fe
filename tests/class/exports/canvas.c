// Canvas: "lovelaceada_40012_880036_file.cl" (see course_system.h).
#include "course_system.h"

#include <string.h>

static SystemName read_canvas(const char *entry)
{
    static const char late[] = "_LATE";
    NamePart parts[NAME_PARTS], more[NAME_PARTS];
    SystemName name = {0};
    // A name may have underscores, but no number between two: the first ones are Canvas'.
    const int is_named = name_matches("_([0-9]+)_([0-9]+)_(.+)$", entry, parts) ||
                         name_matches("_([0-9]+)_()((text|link)\\.html)$", entry, parts);
    // Names are in small letters: only a file's own name may have what looks like another mark, and
    // then it was meant so.
    const int is_late = name_matches("_LATE_[0-9]+_([0-9]+_|(text|link)\\.html)", entry, more) ||
                        name_matches("^LATE_anon_", entry, more);
    // Where submissions are anonymous.
    const int is_anonymous =
        name_matches("^(LATE_)?(anon_[A-Za-z0-9]{5})_[0-9]+_(.+)$", entry, more) ||
        name_matches("^(LATE_)?(anon_[A-Za-z0-9]{5})_((text|link)\\.html)$", entry, more);
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
        name_matches("^[0-9]+_|_[0-9]{3,}_([0-9]{3,}_|(text|link)\\.html$)", parts[3].text, more)) {
        return name;
    }
    name.system = SYSTEM_CANVAS;
    name.name = (NamePart){entry, n_name};
    name.number = parts[1], name.login = parts[1], name.file = parts[3];
    name.is_late = is_late;
    return name;
}

static int is_possible(const char *entry)
{
    NamePart parts[NAME_PARTS];
    return name_matches("^.+_[0-9]+_([0-9]+_.|(text|link)\\.html$)", entry, parts);
}

const CourseSystem canvas_system = {
    .title = "Canvas",
    .identity = "the name and the number before the name of each file",
    .identity_writer = WRITER_SYSTEM,
    .time = "no time, only the mark `LATE`",
    .time_writer = WRITER_SYSTEM,
    .has_marks = 1,
    .read = read_canvas,
    .is_possible = is_possible,
};
