// The roster as JSON, between the driver's start and the gradebook (see roster.h).
#include "complain.h"
#include "output_file.h"
#include "roster.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static json_t *members_json(const Entrant *entrant)
{
    json_t *list = json_array();
    for (int i = 0; i < entrant->n_members; i++) {
        const Member *member = &entrant->members[i];
        json_array_append_new(list, json_pack("{s:s, s:s, s:s}", "name", member->name, "email",
                                              member->email, "sid", member->sid));
    }
    return list;
}

// Returns 0, or -1 where the list is not of the form that members_json() gives it.
static int members_read(json_t *list, Entrant *entrant, json_error_t *error)
{
    const int n = (int)json_array_size(list);
    Member *members = calloc((size_t)n + 1, sizeof *members);
    int failed = members == NULL || !json_is_array(list);
    for (int i = 0; i < n && !failed; i++) {
        failed = json_unpack_ex(json_array_get(list, (size_t)i), error, JSON_STRICT,
                                "{s:s, s:s, s:s}", "name", &members[i].name, "email",
                                &members[i].email, "sid", &members[i].sid) != 0;
    }
    failed = failed || members_copy(members, n, &entrant->members) != 0;
    entrant->n_members = entrant->members != NULL ? n : 0;
    free(members);  // the texts in it are the list's
    return failed ? -1 : 0;
}

int roster_save(const Roster *roster, const char *path)
{
    json_t *list = json_array();
    int failed = list == NULL;
    for (int i = 0; !failed && i < roster->n_entrants; i++) {
        const Entrant *entrant = &roster->entrants[i];
        json_t *entry = json_pack(
            "{s:s, s:s, s:s, s:s, s:i, s:b, s:b, s:o}", "id", entrant->slug, "name", entrant->name,
            "number", entrant->number, "entry", entrant->entry, "attempt", entrant->attempt,
            "exact", entrant->is_exact, "link", entrant->is_link, "members", members_json(entrant));
        failed = json_array_append_new(list, entry) != 0;
    }
    OutputFile output;
    if (failed || output_file_open(&output, path) != 0) {
        if (failed) {
            complain("gradebook: %s: cannot write", path);
        }
        json_decref(list);
        return -1;
    }
    json_dumpf(list, output.file, JSON_INDENT(1));
    json_decref(list);
    return output_file_commit(&output);
}

int roster_load(const char *path, Roster *roster)
{
    json_error_t error;
    json_t *list = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    *roster = (Roster){.entrants = calloc(json_array_size(list) + 1, sizeof(Entrant))};
    int failed = roster->entrants == NULL || !json_is_array(list);
    for (size_t i = 0; !failed && i < json_array_size(list); i++) {
        const char *slug, *name, *number, *entry;
        json_t *members;
        Entrant *entrant = &roster->entrants[roster->n_entrants++];
        failed = json_unpack_ex(json_array_get(list, i), &error, JSON_STRICT,
                                "{s:s, s:s, s:s, s:s, s:i, s:b, s:b, s:o}", "id", &slug, "name",
                                &name, "number", &number, "entry", &entry, "attempt",
                                &entrant->attempt, "exact", &entrant->is_exact, "link",
                                &entrant->is_link, "members", &members) != 0;
        if (!failed) {
            entrant->slug = strdup(slug), entrant->name = strdup(name);
            entrant->number = strdup(number), entrant->entry = strdup(entry);
            failed = entrant->slug == NULL || entrant->name == NULL || entrant->number == NULL ||
                     entrant->entry == NULL || members_read(members, entrant, &error) != 0;
        }
    }
    json_decref(list);
    if (failed) {
        complain("gradebook: %s: line %d: %s", path, error.line, error.text);
        roster_free(roster);
    }
    return failed ? -1 : 0;
}
