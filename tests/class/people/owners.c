// Finding who handed in what (see owners.h).
//
// Read next: participant_fit.h, gradebook_csv.c.
#include "owners.h"

#include "decisions.h"
#include "entry_name.h"
#include "participant_fit.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The first line of the list that a name, which fits none, looks like; 0 for none. It is only
// reported: "carol-2" may be Carol's, or anybody's. Whoever it looks like may have handed in.
static int look_alike_find(const Worksheet *worksheet, const char *name)
{
    int first = 0;
    for (int i = worksheet->n_participants - 1; i >= 1; i--) {
        if (looks_like_participant(worksheet, &worksheet->participants[i], name)) {
            worksheet->participants[i].is_fitted = 1;
            first = i + 1;
        }
    }
    return first;
}

// ---- Who is who --------------------------------------------------------------------------------

typedef struct Search {
    Worksheet *worksheet;
    const Gradebook *gradebook;
    int n_strangers;  // entries, or members of a team, that fit no line
    int has_unnamed;  // a team has members whom nothing names
    int failed;       // memory ran out
} Search;

// Say why a row was not entered for somebody; several reasons are joined.
__attribute__((format(printf, 3, 4))) static void say_why(Search *search, int row,
                                                          const char *format, ...)
{
    char *reason = NULL, *joined = NULL;
    va_list arguments;
    va_start(arguments, format);
    const int length = vasprintf(&reason, format, arguments);
    va_end(arguments);
    char **why_not = &search->worksheet->entered[row].why_not;
    if (length < 0 || asprintf(&joined, "%s%s%s", *why_not != NULL ? *why_not : "",
                               *why_not != NULL ? "; " : "", reason) < 0) {
        search->failed = 1;
    } else {
        free(*why_not);
        *why_not = joined;
    }
    free(length < 0 ? NULL : reason);
}

// Enter a row for the participant in line `line` of the list.
static void enter(Search *search, int row, int line)
{
    Participant *participant = &search->worksheet->participants[line - 1];
    const Row *entered = &search->gradebook->rows[row];
    const Row *before = participant->row;
    int n_versions;
    const Row *first = row_versions(search->gradebook, entered, &n_versions);
    if (before != NULL && before >= first && before < first + n_versions) {
        return;  // the versions of one submission are one
    }
    if (before != NULL) {
        participant->is_contested = 1;
        say_why(search, row, "line %d of the list also fits \"%s\"", line, before->entrant->entry);
        say_why(search, (int)(before - search->gradebook->rows),
                "line %d of the list also fits \"%s\"", line, entered->entrant->entry);
        return;
    }
    participant->row = entered;
}

// Lines of the list that fit, the head being line 1; of more namesakes than this the first.
enum { MOST_LINES = 32 };
typedef struct Lines {
    int n;
    int line[MOST_LINES];
} Lines;

static void lines_add(Lines *lines, int line)
{
    if (lines->n < MOST_LINES) {
        lines->line[lines->n++] = line;
    }
}

// Enter a row for the one line that fits, or say why not. `member`: of several who handed in, whose
// line it is; else "".
static void enter_one(Search *search, int row, const char *member, const Lines *lines)
{
    const char *quote = member[0] != '\0' ? "\" " : "";
    const char *before = member[0] != '\0' ? "\"" : "";
    if (lines->n == 1) {
        enter(search, row, lines->line[0]);
    } else if (lines->n == 0) {
        search->n_strangers++;
        say_why(search, row, "%s%s%sfits no line of the list", before, member, quote);
    } else {
        say_why(search, row,
                "%s%s%sfits %d lines of the list, among them %d and %d: if they are one student, "
                "delete one",
                before, member, quote, lines->n, lines->line[0], lines->line[1]);
    }
    for (int i = 0; i < lines->n; i++) {
        search->worksheet->participants[lines->line[i] - 1].is_fitted = 1;
    }
}

static void member_enter(Search *search, int row, const Member *member)
{
    Worksheet *worksheet = search->worksheet;
    const char *name = member->name[0] != '\0' ? member->name : member->email;
    Lines by_key = {0}, by_name = {0};
    int other = 0, is_named = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (fits_key(worksheet, participant, member)) {
            lines_add(&by_key, i + 1);
            is_named |= fits_member_name(worksheet, participant, member->name) ||
                        fits_name_with_login(worksheet, participant, member);
        } else if (fits_member_name(worksheet, participant, member->name)) {
            if (fits_other_key(worksheet, participant, member)) {
                other = i + 1;
            } else {
                lines_add(&by_name, i + 1);
            }
        }
    }
    if (by_key.n == 0 && by_name.n == 0 && other > 0) {
        worksheet->participants[other - 1].is_fitted = 1;
        say_why(search, row, "\"%s\": line %d of the list has another e-mail address or number",
                name, other);
        return;
    }
    // An address or a number of the university is somebody's for certain, a login is not.
    const int is_login_only = member->email[0] == '\0' && member->sid[0] == '\0';
    if (is_login_only && by_key.n == 1 && !is_named && by_name.n > 0) {
        worksheet->participants[by_key.line[0] - 1].is_fitted = 1;
        worksheet->participants[by_name.line[0] - 1].is_fitted = 1;
        say_why(search, row,
                "\"%s\" is called as line %d of the list, and has the number of line %d", name,
                by_name.line[0], by_key.line[0]);
        return;
    }
    enter_one(search, row, name, by_key.n > 0 ? &by_key : &by_name);
}

// The entry's team, where there is a column of groups. Returns how many lines are of it.
static int team_enter(Search *search, int row, const Entrant *entrant)
{
    const Worksheet *worksheet = search->worksheet;
    int n = 0, stranger = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        Participant *participant = &worksheet->participants[i];
        if (fits_group(worksheet, participant, entrant->name)) {
            participant->is_fitted = 1;
            n++;
        } else if (fits_name(worksheet, participant, entrant->name)) {
            stranger = i + 1;
        }
    }
    if (n > 0 && stranger > 0) {
        say_why(search, row, "is a group of the list and also fits its line %d", stranger);
        return n;
    }
    for (int i = 1; n > 0 && i < worksheet->n_participants; i++) {
        if (fits_group(worksheet, &worksheet->participants[i], entrant->name)) {
            enter(search, row, i + 1);
        }
    }
    return n;
}

// Does an entry fit a participant, whatever the number says?
static int is_entrants(const Worksheet *worksheet, const Participant *participant,
                       const Entrant *entrant, NumberFit fit)
{
    if (fits_as_numbered(worksheet, participant, entrant) ||
        fits_name(worksheet, participant, entrant->name)) {
        return 1;
    }
    char team[ENTRY_NAME_BYTES];
    snprintf(team, sizeof team, "%.*s",
             (int)fits_behind_team(worksheet, participant, entrant->name), entrant->name);
    return (fit == NUMBER_SAME &&
            (team[0] != '\0' || fits_mangled_name(worksheet, participant, entrant->name))) ||
           (team[0] != '\0' && fits_group(worksheet, participant, team));
}

static void person_enter(Search *search, int row, const Entrant *entrant)
{
    Worksheet *worksheet = search->worksheet;
    Lines named = {0}, same = {0};
    int other = 0, squeezed = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        const NumberFit fit = fits_number(worksheet, participant, entrant->number);
        if (!is_entrants(worksheet, participant, entrant, fit)) {
            if (fits_squeezed_name(worksheet, participant, entrant->name)) {
                squeezed = i + 1;
            }
            continue;
        }
        if (fit == NUMBER_OTHER) {
            other = i + 1;
            continue;
        }
        lines_add(&named, i + 1);
        if (fit == NUMBER_SAME) {
            lines_add(&same, i + 1);
        }
    }
    if (named.n == 0 && other > 0) {
        worksheet->participants[other - 1].is_fitted = 1;
        say_why(search, row, "\"%s\": line %d of the list has another number than %s",
                entrant->name, other, entrant->number);
        return;
    }
    if (squeezed > 0) {
        search->n_strangers++;
        worksheet->participants[squeezed - 1].is_fitted = 1;
        say_why(search, row,
                "\"%s\" may be somebody's login, or the name in line %d of the list written as one",
                entrant->name, squeezed);
        return;
    }
    const int like = named.n == 0 ? look_alike_find(worksheet, entrant->name) : 0;
    if (like > 0) {
        search->n_strangers++;
        say_why(search, row, "fits no line of the list, but looks like line %d", like);
        return;
    }
    enter_one(search, row, "", same.n == 1 ? &same : &named);
}

// What the instructor has decided about a row. Returns whether that is anything.
static int decided_enter(Search *search, int row)
{
    Worksheet *worksheet = search->worksheet;
    const Decisions *decisions = search->gradebook->decisions;
    int is_decided = 0;
    for (int i = 0; decisions != NULL && i < decisions->n; i++) {
        const Decision *decision = &decisions->all[i];
        if (decision->row != row || decision->kind == DECISION_TIME) {
            continue;
        }
        is_decided = 1;
        if (decision->participant > 0) {
            worksheet->participants[decision->participant].is_fitted = 1;
        }
        if (decision->kind == DECISION_YES) {
            enter(search, row, decision->participant + 1);
        } else {
            worksheet->entered[row].left_out = decision->kind == DECISION_NO
                                                   ? "another submission counts, as you decided"
                                                   : "ignored, as you decided";
        }
    }
    return is_decided;
}

// What each version of a submission earns, as text for the instructor. Owned; NULL when memory runs
// out.
static char *versions_text(const Row *first, int n)
{
    char *text = NULL;
    size_t n_bytes;
    FILE *file = open_memstream(&text, &n_bytes);
    for (int i = 0; file != NULL && i < n; i++) {
        fprintf(file, "%s\"%s\" ", i > 0 ? ", " : "", first[i].entrant->entry);
        if (row_is_graded(&first[i])) {
            fprintf(file, "earns %d", first[i].score);
        } else {
            fputs(row_status_name(first[i].status), file);
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

// A row that is one of several versions: it counts only if the instructor says so. Returns whether
// the row is settled, as another version counts.
static int version_leave(Search *search, int row)
{
    int n;
    const Gradebook *gradebook = search->gradebook;
    const Decisions *decisions = gradebook->decisions;
    const Row *first = row_versions(gradebook, &gradebook->rows[row], &n);
    for (int i = 0; decisions != NULL && i < decisions->n; i++) {
        const Row *decided = &gradebook->rows[decisions->all[i].row];
        if (decisions->all[i].kind == DECISION_YES && decided >= first && decided < first + n) {
            search->worksheet->entered[row].left_out = "another version counts, as you decided";
            return 1;
        }
    }
    char *text = versions_text(first, n);
    if (text == NULL) {
        search->failed = 1;
        return 1;
    }
    say_why(search, row, "is one of several versions, and no time says which is the last: %s",
            text);
    free(text);
    return 0;
}

// Versions count for nobody until the instructor has decided.
static void versions_contest(Search *search, int row)
{
    int n;
    const Row *first = row_versions(search->gradebook, &search->gradebook->rows[row], &n);
    for (int i = 1; i < search->worksheet->n_participants; i++) {
        Participant *participant = &search->worksheet->participants[i];
        participant->is_contested |= participant->row >= first && participant->row < first + n;
    }
}

int owners_find(Worksheet *worksheet, const Gradebook *gradebook)
{
    Search search = {.worksheet = worksheet, .gradebook = gradebook};
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Entrant *entrant = gradebook->rows[i].entrant;
        if (row_that_counts(gradebook, &gradebook->rows[i]) != &gradebook->rows[i]) {
            continue;
        }
        const int is_version = entrant->version > 0;
        if (decided_enter(&search, i) || (is_version && version_leave(&search, i))) {
            continue;
        }
        const int has_group =
            (entrant->n_members == 0 || entrant->is_team) && team_enter(&search, i, entrant) > 0;
        for (int m = 0; !has_group && m < entrant->n_members; m++) {
            member_enter(&search, i, &entrant->members[m]);
        }
        if (!has_group && entrant->n_members == 0) {
            person_enter(&search, i, entrant);
        }
        // Of those who are not named any may be of the team.
        search.has_unnamed |= !has_group && entrant->is_team;
        if (is_version) {
            versions_contest(&search, i);
        }
    }
    for (int i = 1; i < worksheet->n_participants; i++) {
        Participant *participant = &worksheet->participants[i];
        participant->is_nobody = is_no_person(worksheet, participant);
        participant->row = participant->is_contested ? NULL : participant->row;
        if (participant->row != NULL) {
            worksheet->entered[participant->row - gradebook->rows].n_participants++;
        }
        // An entry that fits nobody may be anybody's.
        participant->is_fitted =
            participant->is_fitted || search.n_strangers > 0 || search.has_unnamed;
    }
    return search.failed ? -1 : 0;
}
