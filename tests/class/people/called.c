// Finding whom a name means (see called.h).
#include "called.h"

#include "participant_fit.h"

#include <string.h>
#include <strings.h>

static void called_add(Called *called, int index)
{
    if (called->n > 0 && called->last == index) {
        return;
    }
    called->first = called->n == 0 ? index : called->first;
    called->last = index;
    called->n++;
}

static int is_member(const Member *member, const char *name)
{
    return strcmp(member->name, name) == 0 || strcasecmp(member->email, name) == 0 ||
           strcmp(member->sid, name) == 0 || strcmp(member->login, name) == 0;
}

static int is_entrant(const Entrant *entrant, const char *name)
{
    int is = strcmp(entrant->slug, name) == 0 || strcmp(entrant->name, name) == 0 ||
             strcmp(entrant->number, name) == 0 || strcmp(entrant->entry, name) == 0;
    for (int i = 0; !is && i < entrant->n_members; i++) {
        is = is_member(&entrant->members[i], name);
    }
    return is;
}

// "Participant 12" is Moodle's number, which stands in a column of its own.
static int is_participant(const Worksheet *worksheet, const Participant *participant,
                          const char *name)
{
    return fits_name(worksheet, participant, name) ||
           strcmp(participant_number(worksheet, participant), name) == 0;
}

// Is the row that of a line of the list which has this name?
static int is_participants(const Worksheet *worksheet, const Row *row, const char *name)
{
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (participant->row == row && is_participant(worksheet, participant, name)) {
            return 1;
        }
    }
    return 0;
}

Called called_student(const Gradebook *gradebook, const Worksheet *worksheet, const char *name)
{
    Called called = {0};
    for (int i = 0; i < gradebook->n_rows && name[0] != '\0'; i++) {
        const Row *row = &gradebook->rows[i];
        if (is_entrant(row->entrant, name) ||
            (worksheet != NULL && is_participants(worksheet, row, name))) {
            called_add(&called, (int)(row_that_counts(gradebook, row) - gradebook->rows));
        }
    }
    return called;
}

Called called_entry(const Gradebook *gradebook, const char *name)
{
    Called called = {0};
    for (int i = 0; i < gradebook->n_rows && name[0] != '\0'; i++) {
        const Entrant *entrant = gradebook->rows[i].entrant;
        if (strcmp(entrant->slug, name) == 0 || strcmp(entrant->entry, name) == 0) {
            called_add(&called, i);
        }
    }
    return called;
}

Called called_participant(const Worksheet *worksheet, const char *name)
{
    Called called = {0};
    for (int i = 1; i < worksheet->n_participants && name[0] != '\0'; i++) {
        if (is_participant(worksheet, &worksheet->participants[i], name)) {
            called_add(&called, i);
        }
    }
    return called;
}
