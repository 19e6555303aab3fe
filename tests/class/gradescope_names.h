// The names in Gradescope's export: submission_metadata.yml, beside folders submission_NUMBER.
#ifndef CLASS_GRADESCOPE_NAMES_H
#define CLASS_GRADESCOPE_NAMES_H

#define GRADESCOPE_NAMES_FILE "submission_metadata.yml"

typedef struct GradescopeName {
    char *entry;  // "submission_123456"
    char *name;   // "Ada Lovelace"; of a group, joined by " & "
} GradescopeName;

typedef struct GradescopeNames {
    GradescopeName *names;
    int n_names;
} GradescopeNames;

// Read the file in a folder of submissions; none there is no fault. Only plain one-line names are
// taken from it, as Gradescope writes them: whose name is written otherwise keeps the folder's.
// Returns 0, or -1 after one message on stderr. Release with gradescope_names_free().
int gradescope_names_load(const char *folder, GradescopeNames *names);
void gradescope_names_free(GradescopeNames *names);

// The name of who handed an entry in, or NULL.
const char *gradescope_names_find(const GradescopeNames *names, const char *entry);

#endif
