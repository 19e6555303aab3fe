// Finding who handed in what (see owners.h).
//
// Read next: gradebook_csv.c.
#include "owners.h"

#include "name_likeness.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Titles as Moodle writes them in English and in German, and what instructors add.
static const char *const number_titles[] = {"Identifier", "ID", NULL};
static const char *const group_titles[] = {"Group", "Gruppe", NULL};
static const char *const first_titles[] = {"First name", "Vorname", NULL};
static const char *const last_titles[] = {"Surname", "Last name", "Nachname", NULL};
static const char *const name_titles[] = {"Full name", "Vollständiger Name", NULL};
static const char *const mail_titles[] = {"Email address", "E-Mail-Adresse", NULL};
static const char *const sid_titles[] = {"ID number", "ID-Nummer", "Matrikelnummer", "Student ID",
                                         NULL};
static const char *const user_titles[] = {"Username", "Anmeldename", "GitHub", "GitHub username",
                                          NULL};

// ---- Names -------------------------------------------------------------------------------------

// The next byte of a name as Moodle puts it into the name of a file: without what file names must
// not hold, and with blanks for underscores.
static unsigned char name_byte(const char **at)
{
    while (**at != '\0' && (iscntrl((unsigned char)**at) || strchr("&<>\"`|':\\/", **at) != NULL)) {
        (*at)++;
    }
    const char byte = **at == '_' ? ' ' : **at;
    *at += byte != '\0';
    return (unsigned char)byte;
}

// Are these the same name, one of them perhaps from the name of a file? Blanks at the end are none.
static int is_same_name(const char *a, const char *b)
{
    unsigned char left, right;
    do {
        left = name_byte(&a), right = name_byte(&b);
    } while (left == right && left != '\0');
    while (left == ' ') {
        left = name_byte(&a);
    }
    while (right == ' ') {
        right = name_byte(&b);
    }
    return left == right && left == '\0';
}

// Case does not tell user names and e-mail addresses apart.
static int is_same_key(const char *cell, const char *key)
{
    return key[0] != '\0' && strcasecmp(cell, key) == 0;
}

// Is this the e-mail address, or the part of it before the @? That tells people apart only where
// all have addresses of one domain: who may give any address may have chosen another one's name.
static int is_mail(const char *cell, const char *name, int has_one_domain)
{
    const size_t length = strlen(name);
    return is_same_key(cell, name) || (has_one_domain && length > 0 && cell[length] == '@' &&
                                       strncasecmp(cell, name, length) == 0);
}

// The words of "Participant 12" before its number.
static size_t words_length(const char *cell)
{
    size_t length = strlen(cell);
    while (length > 0 && isdigit((unsigned char)cell[length - 1])) {
        length--;
    }
    return length;
}

// ---- What fits a participant -------------------------------------------------------------------

// The participant's cell in the first column of such a title, "" where there is none.
static const char *cell_of(const Worksheet *worksheet, const Participant *participant,
                           const char *const *titles)
{
    const int column = worksheet_column(worksheet, titles);
    return column >= 0 ? participant->cells[column] : "";
}

// Are all addresses of the list of one domain?
static int one_domain(const Worksheet *worksheet)
{
    const char *first = NULL;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const char *domain =
            strchr(cell_of(worksheet, &worksheet->participants[i], mail_titles), '@');
        if (domain != NULL && first != NULL && strcasecmp(domain, first) != 0) {
            return 0;
        }
        first = domain != NULL ? domain : first;
    }
    return 1;
}

// Is the participant called so in full?
static int has_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    const char *full = cell_of(worksheet, participant, name_titles);
    const char *first = cell_of(worksheet, participant, first_titles);
    const char *last = cell_of(worksheet, participant, last_titles);
    char both[2][512];
    snprintf(both[0], sizeof both[0], "%s %s", first, last);
    snprintf(both[1], sizeof both[1], "%s %s", last, first);
    return name[0] != '\0' && ((full[0] != '\0' && is_same_name(full, name)) ||
                               (first[0] != '\0' && last[0] != '\0' &&
                                (is_same_name(both[0], name) || is_same_name(both[1], name))));
}

// Does the name stand for the participant in any way?
static int is_called(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    if (has_name(worksheet, participant, name)) {
        return 1;
    }
    for (int i = 0; i < worksheet->n_columns; i++) {
        const char *cell = participant->cells[i];
        if ((worksheet_has_title(worksheet, i, mail_titles) &&
             is_mail(cell, name, worksheet->has_one_domain)) ||
            (worksheet_has_title(worksheet, i, sid_titles) && is_same_key(cell, name)) ||
            (worksheet_has_title(worksheet, i, user_titles) && is_same_key(cell, name))) {
            return 1;
        }
    }
    return 0;
}

typedef enum NumberFit { NUMBER_UNKNOWN, NUMBER_SAME, NUMBER_OTHER } NumberFit;

// Does the entry's number fit the participant's? Only Moodle's own "Participant 12" can differ: a
// bare number may be one of another kind.
static NumberFit number_fit(const char *cell, const char *number)
{
    const size_t n_words = words_length(cell);
    if (number[0] == '\0' || cell[n_words] == '\0') {
        return NUMBER_UNKNOWN;
    }
    if (strcmp(cell + n_words, number) == 0) {
        return NUMBER_SAME;
    }
    return n_words > 0 ? NUMBER_OTHER : NUMBER_UNKNOWN;
}

// Is this the entry "Participant_12_..." of the cell "Participant 12", or one called so in full?
static int is_numbered(const char *cell, const Entrant *entrant)
{
    char words[128];
    const size_t n_words = words_length(cell);
    snprintf(words, sizeof words, "%.*s", (int)n_words, cell);
    return n_words > 0 && n_words < sizeof words && cell[n_words] != '\0' &&
           (is_same_name(cell, entrant->name) ||
            (is_same_name(words, entrant->name) && strcmp(cell + n_words, entrant->number) == 0));
}

// Has the submitter this e-mail address or this number of the university?
static int has_key(const Worksheet *worksheet, const Participant *participant, const Member *member)
{
    return is_same_key(cell_of(worksheet, participant, mail_titles), member->email) ||
           is_same_key(cell_of(worksheet, participant, sid_titles), member->sid);
}

// Of a participant without any of the submitter's keys: is one given on both sides, and differs?
static int has_other_key(const Worksheet *worksheet, const Participant *participant,
                         const Member *member)
{
    return (member->email[0] != '\0' && cell_of(worksheet, participant, mail_titles)[0] != '\0') ||
           (member->sid[0] != '\0' && cell_of(worksheet, participant, sid_titles)[0] != '\0');
}

// Does a name, which fits no line, look like that of this one?
static int looks_like_line(const Worksheet *worksheet, const Participant *participant,
                           const char *name)
{
    static const char *const *const titles[] = {name_titles, user_titles, mail_titles};
    for (size_t t = 0; t < sizeof titles / sizeof *titles; t++) {
        const char *cell = cell_of(worksheet, participant, titles[t]);
        char local[ENTRY_NAME_BYTES];
        snprintf(local, sizeof local, "%.*s", (int)strcspn(cell, "@"), cell);
        if (name_looks_like(name, local)) {
            return 1;
        }
    }
    return 0;
}

// The first line of the list that a name, which fits none, looks like; 0 for none. It is only
// reported: "carol-2" may be Carol's, or anybody's. Whoever it looks like may have handed in.
static int look_alike_find(const Worksheet *worksheet, const char *name)
{
    int first = 0;
    for (int i = worksheet->n_participants - 1; i >= 1; i--) {
        if (looks_like_line(worksheet, &worksheet->participants[i], name)) {
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
    int failed;  // memory ran out
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

// Is a row the next attempt after another, by Moodle's export? The roster alone decides that: its
// attempts stand below each other.
static int is_next_attempt(const Row *before, const Row *row)
{
    return before + 1 == row && before->entrant->attempt + 1 == row->entrant->attempt;
}

// Enter a row for the participant in line `line` of the list. Of attempts the last one counts.
static void enter(Search *search, int row, int line)
{
    Participant *participant = &search->worksheet->participants[line - 1];
    const Row *entered = &search->gradebook->rows[row];
    const Row *before = participant->row;
    if (before != NULL && !is_next_attempt(before, entered)) {
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
        say_why(search, row, "%s%s%sfits no line of the list", before, member, quote);
    } else {
        say_why(search, row, "%s%s%sfits %d lines of the list, among them %d and %d", before,
                member, quote, lines->n, lines->line[0], lines->line[1]);
    }
    for (int i = 0; i < lines->n; i++) {
        search->worksheet->participants[lines->line[i] - 1].is_fitted = 1;
    }
}

static void member_enter(Search *search, int row, const Member *member)
{
    const Worksheet *worksheet = search->worksheet;
    const char *name = member->name[0] != '\0' ? member->name : member->email;
    Lines by_key = {0}, by_name = {0};
    int other = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (has_key(worksheet, participant, member)) {
            lines_add(&by_key, i + 1);
        } else if (has_name(worksheet, participant, member->name)) {
            if (has_other_key(worksheet, participant, member)) {
                other = i + 1;
            } else {
                lines_add(&by_name, i + 1);
            }
        }
    }
    if (by_key.n == 0 && by_name.n == 0 && other > 0) {
        say_why(search, row, "\"%s\": line %d of the list has another e-mail address or number",
                name, other);
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
        const char *group = cell_of(worksheet, participant, group_titles);
        if (group[0] != '\0' && is_same_name(group, entrant->name)) {
            participant->is_fitted = 1;
            n++;
        } else if (is_called(worksheet, participant, entrant->name)) {
            stranger = i + 1;
        }
    }
    if (n > 0 && stranger > 0) {
        say_why(search, row, "is a group of the list and also fits its line %d", stranger);
        return n;
    }
    for (int i = 1; n > 0 && i < worksheet->n_participants; i++) {
        const char *group = cell_of(worksheet, &worksheet->participants[i], group_titles);
        if (group[0] != '\0' && is_same_name(group, entrant->name)) {
            enter(search, row, i + 1);
        }
    }
    return n;
}

static void person_enter(Search *search, int row, const Entrant *entrant)
{
    const Worksheet *worksheet = search->worksheet;
    Lines named = {0}, same = {0};
    int other = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        const char *cell = cell_of(worksheet, participant, number_titles);
        const NumberFit fit = number_fit(cell, entrant->number);
        if (!is_numbered(cell, entrant) && !is_called(worksheet, participant, entrant->name)) {
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
        say_why(search, row, "\"%s\": line %d of the list has another number than %s",
                entrant->name, other, entrant->number);
        return;
    }
    const int like = named.n == 0 ? look_alike_find(worksheet, entrant->name) : 0;
    if (like > 0) {
        say_why(search, row, "fits no line of the list, but looks like line %d", like);
        return;
    }
    enter_one(search, row, "", same.n == 1 ? &same : &named);
}

int owners_find(Worksheet *worksheet, const Gradebook *gradebook)
{
    Search search = {.worksheet = worksheet, .gradebook = gradebook};
    worksheet->has_one_domain = one_domain(worksheet);
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Entrant *entrant = gradebook->rows[i].entrant;
        for (int m = 0; m < entrant->n_members; m++) {
            member_enter(&search, i, &entrant->members[m]);
        }
        if (entrant->n_members == 0 && team_enter(&search, i, entrant) == 0) {
            person_enter(&search, i, entrant);
        }
    }
    for (int i = 1; i < worksheet->n_participants; i++) {
        Participant *participant = &worksheet->participants[i];
        participant->row = participant->is_contested ? NULL : participant->row;
        if (participant->row != NULL) {
            worksheet->entered[participant->row - gradebook->rows].n_participants++;
        }
    }
    return search.failed ? -1 : 0;
}
