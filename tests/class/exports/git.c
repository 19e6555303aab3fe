// Git: clones of GitHub Classroom's repositories, "lab-03-ada" (see course_system.h).
#include "export.h"
#include "path.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

// GitHub Classroom: "lab-03-USER". Returns the length of what stands before the user's name, or 0.
int git_prefix_length(const char *entry, int lab_number)
{
    if (strncasecmp(entry, "lab", 3) != 0) {
        return 0;
    }
    const char *digits = entry + 3 + (entry[3] == '-' || entry[3] == '_');
    char *end;
    if (!isdigit((unsigned char)digits[0]) || strtol(digits, &end, 10) != lab_number ||
        (end[0] != '-' && end[0] != '_') || end[1] == '\0') {
        return 0;
    }
    return (int)(end + 1 - entry);
}

// The prefix that all clones of an assignment have, "rays-" of "rays-ada", "rays-bob", "rays-cy":
// of folders that are repositories. Two may have part of a name in common. Returns its length, or
// 0.
static size_t clones_prefix(const Export *export)
{
    size_t length = 0;
    for (int i = 0; i < export->n_found; i++) {
        char repository[PATH_MAX];
        struct stat status;
        const char *file = export->found[i].file, *first = export->found[0].file;
        path_make(repository, "%s/%s/.git", export->path, file);
        if (lstat(repository, &status) != 0) {
            return 0;
        }
        size_t n = i == 0 ? strlen(file) : 0;
        while (i > 0 && n < length && file[n] == first[n]) {
            n++;
        }
        length = n;
    }
    while (length > 0 && export->found[0].file[length - 1] != '-') {
        length--;
    }
    return length;
}

void git_clones_name(Export *export)
{
    enum { FEWEST = 3 };
    const Found *first = export->found;
    // "lab03-ada" was read already.
    const int is_plain = export->n_found >= FEWEST && strcmp(first->name.name, first->file) == 0;
    const size_t length = is_plain ? clones_prefix(export) : 0;
    for (int i = 0; length > 0 && i < export->n_found; i++) {
        const char *name = export->found[i].file + length;
        entry_name_show(name, strlen(name), export->found[i].name.name);
    }
}

const CourseSystem git_system = {
    .title = "Git",
    .identity = "the name of the clone's folder",
    .identity_writer = WRITER_INSTRUCTOR,
    .time = "the commit that is checked out",
    .time_writer = WRITER_STUDENT,
};
