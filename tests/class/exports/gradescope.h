// Who handed in what, in Gradescope's export: submission_metadata.yml, beside folders
// submission_NUMBER.
#ifndef CLASS_GRADESCOPE_H
#define CLASS_GRADESCOPE_H

#include "entry_name.h"

#define GRADESCOPE_NAMES_FILE "submission_metadata.yml"

// One of those who handed in together, each text fit to be shown; what is not known is "".
typedef struct Member {
    char *name;   // "Ada Lovelace"
    char *email;  // "ada@example.org"
    char *sid;    // the student's number, as the university gives it
    char *login;  // the login, or the course system's number of the student
} Member;

typedef struct GradescopeEntry {
    char *entry;  // "submission_123456"
    char *time;   // when it was handed in, "2026-11-25 22:05:00.5 Z", or ""
    Member *members;
    int n_members;
} GradescopeEntry;

typedef struct GradescopeNames {
    GradescopeEntry *entries;
    int n_entries;
} GradescopeNames;

// Read the file in a folder of submissions; none there is no fault. Only plain one-line values are
// taken from the list of submitters, as Gradescope writes them: what is written otherwise is "".
// Returns 0, or -1 after one message on stderr. Release with gradescope_names_free().
int gradescope_names_load(const char *folder, GradescopeNames *names);
void gradescope_names_free(GradescopeNames *names);

// Who handed an entry in, or NULL.
const GradescopeEntry *gradescope_names_find(const GradescopeNames *names, const char *entry);

// "Ada Lovelace & Grace Hopper", and "..." for those that there is no room for: half a name may be
// no text. Nothing when no name is known.
void gradescope_names_join(const GradescopeEntry *entry, char text[ENTRY_NAME_BYTES]);

// Add one, whose texts are copied, to those that began as NULL and 0. Returns 0, or -1 when memory
// runs out.
int member_add(Member **members, int *n_members, Member member);

// A copy, for another owner. Returns 0, or -1 when memory runs out; release with members_free().
int members_copy(const Member *members, int n_members, Member **copy);
void members_free(Member *members, int n_members);

#endif
