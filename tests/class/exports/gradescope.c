// A reader of the few lines that matter here (see gradescope.h):
//
//     submission_123456:
//       :submitters:
//       - :name: Ada Lovelace
//         :sid: '4711'
//         :email: ada@example.org
//       :created_at: 2026-11-25 22:05:00.711434000 Z
//       :score: 3.0
//
// YAML can do far more than that. What does not look like this is passed over: further down stands
// what the submission printed, which must not name anybody.
#include "gradescope.h"

#include "entry_name.h"
#include "path.h"
#include "sheet.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINE_BYTES = 1024, KEY_INDENT = 2 };

// ---- Members -----------------------------------------------------------------------------------

static int member_make(Member from, Member *member)
{
    *member = (Member){strdup(from.name), strdup(from.email), strdup(from.sid), strdup(from.login)};
    return member->name != NULL && member->email != NULL && member->sid != NULL &&
                   member->login != NULL
               ? 0
               : -1;
}

void members_free(Member *members, int n_members)
{
    for (int i = 0; i < n_members; i++) {
        free(members[i].name), free(members[i].email), free(members[i].sid);
        free(members[i].login);
    }
    free(members);
}

int members_copy(const Member *members, int n_members, Member **copy)
{
    *copy = calloc((size_t)n_members + 1, sizeof **copy);
    int failed = *copy == NULL;
    for (int i = 0; i < n_members && !failed; i++) {
        failed = member_make(members[i], &(*copy)[i]) != 0;
    }
    return failed ? -1 : 0;
}

// ---- Reading -----------------------------------------------------------------------------------

// Room for one more in an array that doubles. Returns the array, or NULL when memory runs out.
static void *grown(void *array, int n, size_t size)
{
    if ((n & (n - 1)) != 0) {
        return array;
    }
    return realloc(array, (n > 0 ? 2 * (size_t)n : 1) * size);
}

// Begin the entry that a line "submission_N:" names. Returns 0, or -1 when memory runs out.
static int entry_begin(GradescopeNames *names, const char *line)
{
    GradescopeEntry *entries = grown(names->entries, names->n_entries, sizeof *entries);
    if (entries == NULL) {
        return -1;
    }
    names->entries = entries;
    GradescopeEntry *entry = &entries[names->n_entries++];
    *entry = (GradescopeEntry){.entry = strndup(line, strcspn(line, ":")), .time = strdup("")};
    return entry->entry != NULL && entry->time != NULL ? 0 : -1;
}

int member_add(Member **members, int *n_members, Member member)
{
    Member *more = grown(*members, *n_members, sizeof *more);
    if (more == NULL) {
        return -1;
    }
    *members = more;
    return member_make(member, &more[(*n_members)++]);
}

static int member_begin(GradescopeEntry *entry)
{
    char none[] = "";
    return member_add(&entry->members, &entry->n_members, (Member){none, none, none, none});
}

// A value's text: in quotes it counts without them; with an escape, or as anything that is no plain
// text, not at all.
static int value_set(char **value, const char *text)
{
    size_t length = strlen(text);
    if (length >= 2 && (text[0] == '"' || text[0] == '\'') && text[length - 1] == text[0]) {
        text++, length -= 2;
    } else if (strcmp(text, "~") == 0 || strcmp(text, "null") == 0 ||
               strchr("|>&*!%@`[{\"'", text[0]) != NULL) {
        return 0;
    }
    if (memchr(text, '\\', length) != NULL || memmem(text, length, "''", 2) != NULL) {
        return 0;
    }
    char shown[ENTRY_NAME_BYTES];
    entry_name_show(text, length, shown);
    free(*value);
    *value = strdup(shown);
    return *value != NULL ? 0 : -1;
}

// A line ":key: value" of a submitter.
static int member_read(Member *member, const char *text)
{
    const struct {
        const char *key;
        char **value;
    } known[] = {
        {":name: ", &member->name}, {":email: ", &member->email}, {":sid: ", &member->sid}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strncmp(text, known[i].key, strlen(known[i].key)) == 0) {
            return value_set(known[i].value, text + strlen(known[i].key));
        }
    }
    return 0;
}

// A line of the file; *in_list: the lines are those of an entry's submitters. Returns 0, or -1 when
// memory runs out.
static int line_read(GradescopeNames *names, const char *line, int *in_list)
{
    const int indent = (int)strspn(line, " ");
    const char *text = line + indent;
    if (indent == 0) {
        *in_list = 0;
        const int is_entry = strncmp(line, "submission_", strlen("submission_")) == 0;
        return is_entry ? entry_begin(names, line) : 0;
    }
    if (names->n_entries == 0) {
        return 0;
    }
    GradescopeEntry *entry = &names->entries[names->n_entries - 1];
    const int is_item = strncmp(text, "- ", 2) == 0;
    if (indent <= KEY_INDENT && !is_item) {
        static const char time_key[] = ":created_at: ";
        *in_list = strcmp(text, ":submitters:") == 0 && entry->n_members == 0;
        const int is_time = strncmp(text, time_key, strlen(time_key)) == 0;
        return is_time ? value_set(&entry->time, text + strlen(time_key)) : 0;
    }
    if (!*in_list || (is_item && member_begin(entry) != 0)) {
        return *in_list ? -1 : 0;
    }
    return entry->n_members > 0
               ? member_read(&entry->members[entry->n_members - 1], text + (is_item ? 2 : 0))
               : 0;
}

// Open a file for reading; *file is NULL where there is none, or a folder, a pipe or the like of
// this name, which a student may have chosen. Returns 0, or -1 with errno set.
static int regular_file_open(const char *path, FILE **file)
{
    struct stat status;
    *file = NULL;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        return errno == ENOENT || errno == ENXIO ? 0 : -1;
    }
    int result = fstat(descriptor, &status);
    if (result == 0 && S_ISREG(status.st_mode)) {
        *file = fdopen(descriptor, "r");
        result = *file != NULL ? 0 : -1;
    }
    if (*file == NULL) {
        close(descriptor);
    }
    return result;
}

int gradescope_names_load(const char *folder, GradescopeNames *names)
{
    char path[PATH_MAX], line[LINE_BYTES];
    *names = (GradescopeNames){0};
    path_make(path, "%s/%s", folder, GRADESCOPE_NAMES_FILE);
    FILE *file;
    if (regular_file_open(path, &file) != 0) {
        return path_fault(path, strerror(errno));
    }
    if (file == NULL) {
        return 0;
    }
    int failed = 0;
    int is_line_start = 1;
    int in_list = 0;
    while (!failed && fgets(line, sizeof line, file) != NULL) {
        const size_t length = strcspn(line, "\r\n");
        const int is_whole = line[length] != '\0' || feof(file);
        line[length] = '\0';
        // Of a line that is too long for a name the beginning would be another's name.
        if (is_line_start && is_whole) {
            failed = line_read(names, line, &in_list) != 0;
        }
        is_line_start = is_whole;
    }
    fclose(file);
    return failed ? path_fault(path, "out of memory") : 0;
}

void gradescope_names_free(GradescopeNames *names)
{
    for (int i = 0; i < names->n_entries; i++) {
        free(names->entries[i].entry), free(names->entries[i].time);
        members_free(names->entries[i].members, names->entries[i].n_members);
    }
    free(names->entries);
    *names = (GradescopeNames){0};
}

const GradescopeEntry *gradescope_names_find(const GradescopeNames *names, const char *entry)
{
    for (int i = 0; i < names->n_entries; i++) {
        if (strcmp(names->entries[i].entry, entry) == 0) {
            return &names->entries[i];
        }
    }
    return NULL;
}

void gradescope_names_join(const GradescopeEntry *entry, char text[ENTRY_NAME_BYTES])
{
    size_t length = 0;
    for (int i = 0; i < entry->n_members; i++) {
        const char *name = entry->members[i].name;
        const char *joint = length > 0 ? " & " : "";
        if (length + strlen(joint) + strlen(name) + sizeof " & ..." > ENTRY_NAME_BYTES) {
            snprintf(text + length, ENTRY_NAME_BYTES - length, "%s...", joint);
            return;
        }
        if (name[0] != '\0') {
            length +=
                (size_t)snprintf(text + length, ENTRY_NAME_BYTES - length, "%s%s", joint, name);
        }
    }
}

// Gradescope: "submission_NUMBER"; the number is a submission's, the name stays as it is.
void gradescope_name_read(const char *entry, int length, EntryName *name)
{
    const char *digits = entry + strlen("submission_");
    if (strncmp(entry, "submission_", strlen("submission_")) == 0) {
        const int n_digits = (int)strspn(digits, "0123456789");
        if (n_digits > 0 && n_digits < ENTRY_NUMBER_BYTES && digits + n_digits == entry + length) {
            snprintf(name->number, sizeof name->number, "%.*s", n_digits, digits);
        }
    }
}

const CourseSystem gradescope_system = {
    .title = "Gradescope",
    .identity = "`submission_metadata.yml` beside folders `submission_N`",
    .identity_writer = WRITER_SYSTEM,
    .time = "`submission_metadata.yml`",
    .time_writer = WRITER_SYSTEM,
};
