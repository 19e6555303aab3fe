// Comparing names, numbers and keys (see participant_fit.h).
#include "participant_fit.h"

#include "ilias.h"
#include "name_likeness.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Whose "ID" is the number that Canvas writes into names of files.
static const char *const canvas_titles[] = {"SIS Login ID", "SIS User ID", NULL};

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
static int is_same_name(const char *first, const char *second)
{
    char composed[2][ENTRY_NAME_BYTES];
    name_compose(first, composed[0]), name_compose(second, composed[1]);
    const char *a = composed[0], *b = composed[1];
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

// "Lovelace, Ada" as "Ada Lovelace"; "" where there is no comma.
static void name_turn(const char *name, char turned[ENTRY_NAME_BYTES])
{
    const char *comma = strchr(name, ',');
    const char *first = comma != NULL ? comma + 1 + strspn(comma + 1, " _") : "";
    turned[0] = '\0';
    if (first[0] != '\0' && comma > name) {
        snprintf(turned, ENTRY_NAME_BYTES, "%s %.*s", first, (int)(comma - name), name);
    }
}

// Are these the same name, either of them perhaps with the last name first and a comma behind it?
static int is_same_person(const char *cell, const char *name)
{
    char turned[ENTRY_NAME_BYTES];
    name_turn(name, turned);
    if (is_same_name(cell, name) || (turned[0] != '\0' && is_same_name(cell, turned))) {
        return 1;
    }
    name_turn(cell, turned);
    return turned[0] != '\0' && is_same_name(turned, name);
}

// A name without what a zip program may have mangled: only its ASCII, and none of the escapes that
// stand for other bytes ("\\x94" of ours, "#U00f6" of unzip, "?").
static void name_strip(const char *name, char stripped[ENTRY_NAME_BYTES])
{
    char composed[ENTRY_NAME_BYTES];
    name_compose(name, composed);
    size_t n = 0;
    for (const char *at = composed; *at != '\0';) {
        const char *digits =
            strncmp(at, "\\x", 2) == 0 || strncmp(at, "#U", 2) == 0 ? at + 2 : NULL;
        const int n_wanted = *at == '#' ? 4 : 2;
        if (digits != NULL && (int)strspn(digits, "0123456789ABCDEFabcdef") >= n_wanted) {
            at = digits + n_wanted;
        } else if ((unsigned char)*at >= 0x80 || *at == '?') {
            at++;
        } else {
            stripped[n++] = *at++;
        }
    }
    stripped[n] = '\0';
}

// Is a name what Canvas makes of "Lovelace, Ada": small letters and digits, and nothing between
// them?
static int is_squeezed(const char *cell, const char *name)
{
    for (; *cell != '\0'; cell++) {
        const unsigned char letter = (unsigned char)*cell;
        if (letter < 0x80 && !isalnum(letter)) {
            continue;
        }
        if ((unsigned char)*name++ != tolower(letter)) {
            return 0;
        }
    }
    return *name == '\0';
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

int fits_group(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    const char *group = participant_cell(worksheet, participant, CELL_GROUP);
    return group[0] != '\0' && is_same_name(group, name);
}

int fits_full_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    const FullNames names = full_names(worksheet, participant);
    int fits = 0;
    for (int i = 0; i < 3 && name[0] != '\0'; i++) {
        const char *text = names.text[i];
        fits = fits || (text[0] != '\0' && is_same_person(text, name));
    }
    return fits;
}

int fits_squeezed_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    const FullNames names = full_names(worksheet, participant);
    int fits = 0;
    for (int i = 0; i < 3 && name[0] != '\0'; i++) {
        fits = fits || (names.text[i][0] != '\0' && is_squeezed(names.text[i], name));
    }
    return fits;
}

int fits_member_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    return fits_full_name(worksheet, participant, name) ||
           fits_squeezed_name(worksheet, participant, name);
}

int fits_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    if (fits_full_name(worksheet, participant, name)) {
        return 1;
    }
    for (int i = 0; i < worksheet->n_columns; i++) {
        const char *cell = participant->cells[i];
        if ((column_is(worksheet, i, CELL_MAIL) &&
             is_mail(cell, name, worksheet->has_one_domain)) ||
            ((column_is(worksheet, i, CELL_SID) || column_is(worksheet, i, CELL_USER)) &&
             is_same_key(plain_key(cell), plain_key(name)))) {
            return 1;
        }
    }
    return 0;
}

NumberFit fits_number(const Worksheet *worksheet, const Participant *participant,
                      const char *number)
{
    const char *cell = participant_cell(worksheet, participant, CELL_NUMBER);
    const size_t n_words = words_length(cell);
    if (number[0] == '\0' || cell[n_words] == '\0') {
        return NUMBER_UNKNOWN;
    }
    if (strcmp(cell + n_words, number) == 0) {
        return NUMBER_SAME;
    }
    return n_words > 0 ? NUMBER_OTHER : NUMBER_UNKNOWN;
}

int fits_as_numbered(const Worksheet *worksheet, const Participant *participant,
                     const Entrant *entrant)
{
    const char *cell = participant_cell(worksheet, participant, CELL_NUMBER);
    char words[128];
    const size_t n_words = words_length(cell);
    snprintf(words, sizeof words, "%.*s", (int)n_words, cell);
    return n_words > 0 && n_words < sizeof words && cell[n_words] != '\0' &&
           (is_same_name(cell, entrant->name) ||
            (is_same_name(words, entrant->name) && strcmp(cell + n_words, entrant->number) == 0));
}

int fits_mangled_name(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    const FullNames names = full_names(worksheet, participant);
    char found[ENTRY_NAME_BYTES], wanted[ENTRY_NAME_BYTES];
    name_strip(name, found);
    for (int i = 0; i < 3; i++) {
        name_strip(names.text[i], wanted);
        if (wanted[0] != '\0' && is_same_name(wanted, found)) {
            return 1;
        }
    }
    return 0;
}

size_t fits_behind_team(const Worksheet *worksheet, const Participant *participant,
                        const char *name)
{
    for (const char *dash = strchr(name, '-'); dash != NULL; dash = strchr(dash + 1, '-')) {
        if (dash > name && (fits_full_name(worksheet, participant, dash + 1) ||
                            fits_mangled_name(worksheet, participant, dash + 1))) {
            return (size_t)(dash - name);
        }
    }
    return 0;
}

int fits_name_with_login(const Worksheet *worksheet, const Participant *participant,
                         const Member *member)
{
    const FullNames names = full_names(worksheet, participant);
    const char *user = participant_cell(worksheet, participant, CELL_USER);
    char found[2 * ENTRY_NAME_BYTES], wanted[2 * ENTRY_NAME_BYTES], ascii[2 * ENTRY_NAME_BYTES];
    snprintf(found, sizeof found, "%s %s", member->name, member->login);
    for (int i = 0; i < 3 && user[0] != '\0'; i++) {
        snprintf(wanted, sizeof wanted, "%s %s", names.text[i], user);
        ilias_name_make(wanted, ascii, sizeof ascii);
        if (names.text[i][0] == '\0') {
            continue;
        }
        if (is_same_name(wanted, found) || is_same_name(ascii, found)) {
            return 1;
        }
        // VPL writes an underscore for more signs than others.
        for (char *at = wanted; (at = strpbrk(at, "?.,:*\\<>|/")) != NULL; at++) {
            *at = '_';
        }
        if (is_same_name(wanted, found)) {
            return 1;
        }
    }
    return 0;
}

// Canvas' number, where the list is Canvas'. Any other login or number may be one of another kind:
// so the name has to fit, too.
static int is_login(const Worksheet *worksheet, const Participant *participant,
                    const Member *member)
{
    static const char *const id_titles[] = {"ID", NULL};
    static const char *const brightspace_titles[] = {"OrgDefinedId", NULL};
    if (member->login[0] == '\0') {
        return 0;
    }
    if (worksheet_column(worksheet, canvas_titles) >= 0) {
        return is_same_key(cell_at(participant, worksheet_column(worksheet, id_titles)),
                           member->login);
    }
    const char *number = cell_at(participant, worksheet_column(worksheet, brightspace_titles));
    return (fits_member_name(worksheet, participant, member->name) &&
            is_same_key(plain_key(number), member->login)) ||
           fits_name_with_login(worksheet, participant, member);
}

int fits_key(const Worksheet *worksheet, const Participant *participant, const Member *member)
{
    return is_same_key(participant_cell(worksheet, participant, CELL_MAIL), member->email) ||
           is_same_key(participant_sid(worksheet, participant), plain_key(member->sid)) ||
           is_login(worksheet, participant, member);
}

int fits_other_key(const Worksheet *worksheet, const Participant *participant, const Member *member)
{
    return (member->email[0] != '\0' &&
            participant_cell(worksheet, participant, CELL_MAIL)[0] != '\0') ||
           (member->sid[0] != '\0' &&
            participant_cell(worksheet, participant, CELL_SID)[0] != '\0');
}

int looks_like_participant(const Worksheet *worksheet, const Participant *participant,
                           const char *name)
{
    const int columns[] = {participant_column(worksheet, CELL_NAME),
                           participant_column(worksheet, CELL_USER),
                           participant_column(worksheet, CELL_MAIL)};
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++) {
        const char *cell = cell_at(participant, columns[i]);
        char local[ENTRY_NAME_BYTES];
        snprintf(local, sizeof local, "%.*s", (int)strcspn(cell, "@"), cell);
        if (name_looks_like(name, local)) {
            return 1;
        }
    }
    return 0;
}

int has_one_domain(const Worksheet *worksheet)
{
    const char *first = NULL;
    for (int i = 1; i < worksheet->n_participants; i++) {
        const char *domain =
            strchr(participant_cell(worksheet, &worksheet->participants[i], CELL_MAIL), '@');
        if (domain != NULL && first != NULL && strcasecmp(domain, first) != 0) {
            return 0;
        }
        first = domain != NULL ? domain : first;
    }
    return 1;
}

int is_no_person(const Worksheet *worksheet, const Participant *participant)
{
    static const char *const id_titles[] = {"ID", NULL};
    return worksheet_column(worksheet, canvas_titles) >= 0 &&
           cell_at(participant, worksheet_column(worksheet, id_titles))[0] == '\0';
}
