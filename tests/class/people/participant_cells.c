// Finding the columns of a list (see participant_cells.h).
#include "participant_cells.h"

#include <stdio.h>
#include <string.h>

// Titles as course systems write them in English and in German, and what instructors add, in small
// letters or capitals. New ones are listed in tests/INSTRUCTORS.md, too.
static const char *const number_titles[] = {"Identifier", "ID", NULL};
static const char *const group_titles[] = {"Group", "Gruppe", NULL};
static const char *const first_titles[] = {"First name", "FirstName", "Given name", "Vorname",
                                           NULL};
static const char *const last_titles[] = {"Last name",   "LastName", "Surname",
                                          "Family name", "Nachname", NULL};
static const char *const name_titles[] = {"Full name", "Vollständiger Name", "Student", NULL};
// The last name beside a column of first names, else the whole name.
static const char *const either_titles[] = {"Name", NULL};
static const char *const mail_titles[] = {
    "Email address", "E-Mail-Adresse", "E-Mail address", "E-Mail", "Email", "Mail", NULL};
static const char *const sid_titles[] = {
    "ID number",    "ID-Nummer",   "Student ID",      "Student number", "Matrikelnummer",
    "Matrikel-Nr.", "Matrikel-Nr", "Matrikelnr.",     "Matrikelnr",     "Matr.-Nr.",
    "Matr.-Nr",     "MatrNr",      "Matrikel Nummer", "Matrikel",       "OrgDefinedId",
    "SIS User ID",  NULL};
static const char *const user_titles[] = {
    "Username", "Anmeldename",  "Benutzername",    "Nutzername", "Nutzernamen",
    "Login",    "SIS Login ID", "GitHub username", "GitHub",     NULL};

static const char *const *titles_of(CellKind kind)
{
    static const char *const *const titles[N_CELL_KINDS] = {
        [CELL_NUMBER] = number_titles, [CELL_GROUP] = group_titles, [CELL_FIRST] = first_titles,
        [CELL_LAST] = last_titles,     [CELL_NAME] = name_titles,   [CELL_MAIL] = mail_titles,
        [CELL_SID] = sid_titles,       [CELL_USER] = user_titles};
    return titles[kind];
}

int column_is(const Worksheet *worksheet, int column, CellKind kind)
{
    return worksheet_has_title(worksheet, column, titles_of(kind));
}

int participant_column(const Worksheet *worksheet, CellKind kind)
{
    const int column = worksheet_column(worksheet, titles_of(kind));
    if (column >= 0 || (kind != CELL_LAST && kind != CELL_NAME)) {
        return column;
    }
    const int is_last = worksheet_column(worksheet, first_titles) >= 0 &&
                        worksheet_column(worksheet, last_titles) < 0;
    return is_last == (kind == CELL_LAST) ? worksheet_column(worksheet, either_titles) : -1;
}

const char *cell_at(const Participant *participant, int column)
{
    return column >= 0 ? participant->cells[column] : "";
}

const char *participant_cell(const Worksheet *worksheet, const Participant *participant,
                             CellKind kind)
{
    return cell_at(participant, participant_column(worksheet, kind));
}

const char *plain_key(const char *key)
{
    return key + (key[0] == '#');
}

FullNames full_names(const Worksheet *worksheet, const Participant *participant)
{
    const char *first = participant_cell(worksheet, participant, CELL_FIRST);
    const char *last = participant_cell(worksheet, participant, CELL_LAST);
    FullNames names = {0};
    snprintf(names.text[0], sizeof names.text[0], "%s",
             participant_cell(worksheet, participant, CELL_NAME));
    if (first[0] != '\0' || last[0] != '\0') {
        snprintf(names.text[1], sizeof names.text[1], "%s %s", first, last);
        snprintf(names.text[2], sizeof names.text[2], "%s %s", last, first);
    }
    return names;
}

void participant_name(const Worksheet *worksheet, const Participant *participant,
                      char name[ENTRY_NAME_BYTES])
{
    const FullNames names = full_names(worksheet, participant);
    snprintf(name, ENTRY_NAME_BYTES, "%s",
             names.text[0][0] != '\0' ? names.text[0] : names.text[1]);
}

const char *participant_number(const Worksheet *worksheet, const Participant *participant)
{
    return participant_cell(worksheet, participant, CELL_NUMBER);
}

const char *participant_address(const Worksheet *worksheet, const Participant *participant)
{
    return participant_cell(worksheet, participant, CELL_MAIL);
}

const char *participant_sid(const Worksheet *worksheet, const Participant *participant)
{
    return plain_key(participant_cell(worksheet, participant, CELL_SID));
}

int has_persons(const Worksheet *worksheet)
{
    static const CellKind kinds[] = {CELL_NUMBER, CELL_NAME, CELL_FIRST, CELL_LAST,
                                     CELL_MAIL,   CELL_SID,  CELL_USER};
    size_t i = 0;
    while (i < sizeof kinds / sizeof *kinds && participant_column(worksheet, kinds[i]) < 0) {
        i++;
    }
    return i < sizeof kinds / sizeof *kinds;
}
