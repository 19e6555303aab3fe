// The roster as JSON, between the driver's start and the gradebook (see roster.h).
#include "complain.h"
#include "course_system.h"
#include "output_file.h"
#include "roster.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static json_t *members_json(const Entrant *entrant)
{
    json_t *list = json_array();
    for (int i = 0; i < entrant->n_members; i++) {
        const Member *member = &entrant->members[i];
        json_array_append_new(list,
                              json_pack("{s:s, s:s, s:s, s:s}", "name", member->name, "email",
                                        member->email, "sid", member->sid, "login", member->login));
    }
    return list;
}

// Returns 0, or -1 where the list is not of the form that members_json() gives it.
static int members_read(json_t *list, Entrant *entrant, json_error_t *error)
{
    const int n = (int)json_array_size(list);
    entrant->members = calloc((size_t)n + 1, sizeof *entrant->members);
    int failed = entrant->members == NULL || !json_is_array(list);
    for (int i = 0; i < n && !failed; i++) {
        Member *member = &entrant->members[entrant->n_members++];
        failed = json_unpack_ex(json_array_get(list, (size_t)i), error, JSON_STRICT,
                                "{s:s, s:s, s:s, s:s}", "name", &member->name, "email",
                                &member->email, "sid", &member->sid, "login", &member->login) != 0;
    }
    return failed ? -1 : 0;
}

int roster_save(const Roster *roster, const char *path)
{
    json_t *list = json_array();
    json_t *passed_over = json_array();
    int failed = list == NULL || passed_over == NULL;
    for (int i = 0; !failed && i < roster->n_passed_over; i++) {
        failed = json_array_append_new(passed_over, json_string(roster->passed_over[i])) != 0;
    }
    for (int i = 0; !failed && i < roster->n_entrants; i++) {
        const Entrant *entrant = &roster->entrants[i];
        json_t *entry = json_pack(
            "{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:b, s:i, s:i, s:b, s:b, s:b, s:o}", "id",
            entrant->slug, "name", entrant->name, "label", entrant->label, "number",
            entrant->number, "entry", entrant->entry, "time", entrant->time, "time_from",
            course_system(entrant->time_from)->title, "late", entrant->is_late, "attempt",
            entrant->attempt, "version", entrant->version, "exact", entrant->is_exact, "link",
            entrant->is_link, "team", entrant->is_team, "members", members_json(entrant));
        failed = json_array_append_new(list, entry) != 0;
    }
    json_t *whole = json_pack("{s:o, s:o}", "entries", list, "passed_over", passed_over);
    OutputFile output;
    if (failed || whole == NULL || output_file_open(&output, path) != 0) {
        if (failed || whole == NULL) {
            complain("gradebook: %s: cannot write", path);
        }
        json_decref(whole);
        return -1;
    }
    json_dumpf(whole, output.file, JSON_INDENT(1));
    json_decref(whole);
    return output_file_commit(&output);
}

// Returns 0, or -1 where the list is not of the form that roster_save() gives it.
static int passed_over_read(json_t *list, Roster *roster)
{
    roster->passed_over = calloc(json_array_size(list) + 1, sizeof *roster->passed_over);
    int failed = roster->passed_over == NULL || !json_is_array(list);
    for (size_t i = 0; !failed && i < json_array_size(list); i++) {
        failed = json_unpack(json_array_get(list, i), "s", &roster->passed_over[i]) != 0;
        roster->n_passed_over += !failed;
    }
    return failed ? -1 : 0;
}

static int entrant_read(json_t *json, Entrant *entrant, json_error_t *error)
{
    const char *time_from;
    json_t *members;
    if (json_unpack_ex(json, error, JSON_STRICT,
                       "{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:b, s:i, s:i, s:b, s:b, s:b, s:o}",
                       "id", &entrant->slug, "name", &entrant->name, "label", &entrant->label,
                       "number", &entrant->number, "entry", &entrant->entry, "time", &entrant->time,
                       "time_from", &time_from, "late", &entrant->is_late, "attempt",
                       &entrant->attempt, "version", &entrant->version, "exact", &entrant->is_exact,
                       "link", &entrant->is_link, "team", &entrant->is_team, "members",
                       &members) != 0) {
        return -1;
    }
    entrant->time_from = course_system_find(time_from);
    return members_read(members, entrant, error);
}

int roster_load(const char *path, Roster *roster)
{
    json_error_t error;
    if (access(path, F_OK) != 0) {
        complain("gradebook: %s: there is no graded class, expected OUTPUT= of make grade-class",
                 path);
        *roster = (Roster){0};
        return -1;
    }
    json_t *whole = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    json_t *list = json_object_get(whole, "entries");
    *roster =
        (Roster){.json = whole, .entrants = calloc(json_array_size(list) + 1, sizeof(Entrant))};
    int failed = roster->entrants == NULL || !json_is_array(list) ||
                 passed_over_read(json_object_get(whole, "passed_over"), roster) != 0;
    for (size_t i = 0; !failed && i < json_array_size(list); i++) {
        Entrant *entrant = &roster->entrants[roster->n_entrants++];
        failed = entrant_read(json_array_get(list, i), entrant, &error) != 0;
    }
    if (failed) {
        complain("gradebook: %s: line %d: %s", path, error.line, error.text);
        roster_free(roster);
    }
    return failed ? -1 : 0;
}
