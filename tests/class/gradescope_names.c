// A reader of the few lines that matter here (see gradescope_names.h):
//
//     submission_123456:
//       :submitters:
//       - :name: Ada Lovelace
//         :email: ada@example.org
//
// YAML can do far more than that. What does not look like this is passed over.
#include "gradescope_names.h"

#include "complain.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_BYTES = 256, LINE_BYTES = 1024 };

static int fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

// Begin the entry that a line "submission_N:" names. Returns 0, or -1 when memory runs out.
static int entry_begin(GradescopeNames *names, const char *line)
{
    if ((names->n_names & (names->n_names - 1)) == 0) {
        const size_t n = names->n_names > 0 ? 2 * (size_t)names->n_names : 1;
        GradescopeName *grown = realloc(names->names, n * sizeof *grown);
        if (grown == NULL) {
            return -1;
        }
        names->names = grown;
    }
    GradescopeName *name = &names->names[names->n_names++];
    *name = (GradescopeName){strndup(line, strcspn(line, ":")), NULL};
    return name->entry != NULL ? 0 : -1;
}

// Add a submitter's name to the entry. In quotes it counts without them; with an escape not at all.
static int submitter_add(GradescopeName *entry, const char *text)
{
    char joined[NAME_BYTES];
    size_t length = strlen(text);
    if (length >= 2 && (text[0] == '"' || text[0] == '\'') && text[length - 1] == text[0]) {
        text++, length -= 2;
    }
    if (length == 0 || memchr(text, '\\', length) != NULL ||
        strchr("|>&*!%@`[{", text[0]) != NULL) {
        return 0;
    }
    snprintf(joined, sizeof joined, "%s%s%.*s", entry->name ? entry->name : "",
             entry->name ? " & " : "", (int)length, text);
    free(entry->name);
    entry->name = strdup(joined);
    return entry->name != NULL ? 0 : -1;
}

int gradescope_names_load(const char *folder, GradescopeNames *names)
{
    static const char submitter[] = "- :name: ";
    char path[PATH_MAX], line[LINE_BYTES];
    *names = (GradescopeNames){0};
    snprintf(path, sizeof path, "%s/%s", folder, GRADESCOPE_NAMES_FILE);
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return errno == ENOENT ? 0 : fault(path, strerror(errno));
    }
    int failed = 0;
    int is_line_start = 1;
    while (!failed && fgets(line, sizeof line, file) != NULL) {
        const size_t length = strcspn(line, "\r\n");
        const int is_whole = line[length] != '\0';
        line[length] = '\0';
        const char *text = line + strspn(line, " ");
        if (is_line_start && strncmp(line, "submission_", strlen("submission_")) == 0) {
            failed = entry_begin(names, line);
        } else if (is_line_start && names->n_names > 0 &&
                   strncmp(text, submitter, strlen(submitter)) == 0) {
            failed = submitter_add(&names->names[names->n_names - 1], text + strlen(submitter));
        }
        is_line_start = is_whole;
    }
    fclose(file);
    return failed ? fault(path, "out of memory") : 0;
}

void gradescope_names_free(GradescopeNames *names)
{
    for (int i = 0; i < names->n_names; i++) {
        free(names->names[i].entry), free(names->names[i].name);
    }
    free(names->names);
    *names = (GradescopeNames){0};
}

const char *gradescope_names_find(const GradescopeNames *names, const char *entry)
{
    for (int i = 0; i < names->n_names; i++) {
        if (strcmp(names->names[i].entry, entry) == 0) {
            return names->names[i].name;
        }
    }
    return NULL;
}
