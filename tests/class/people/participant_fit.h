// Does a name, a number or a key stand for a participant of a list? Used by owners.c, which decides
// what follows.
#ifndef CLASS_PARTICIPANT_FIT_H
#define CLASS_PARTICIPANT_FIT_H

#include "entry_name.h"
#include "participant_cells.h"

// Is the entry's name that of the participant's group, where the list has a column of groups?
int fits_group(const Worksheet *worksheet, const Participant *participant, const char *name);

// Is the participant called so in full? As names of files have it, whichever way Unicode writes an
// accent, and also as "Lovelace, Ada".
int fits_full_name(const Worksheet *worksheet, const Participant *participant, const char *name);

// Would Canvas call the participant so, "lovelaceada"? From any other system it may be somebody's
// login.
int fits_squeezed_name(const Worksheet *worksheet, const Participant *participant,
                       const char *name);

// Either of the two, for a submitter that a system has named.
int fits_member_name(const Worksheet *worksheet, const Participant *participant, const char *name);

// Does the name stand for the participant in any way: in full, as user name, number or e-mail
// address?
int fits_name(const Worksheet *worksheet, const Participant *participant, const char *name);

// Does the entry's number fit the participant's? Only Moodle's own "Participant 12" can differ: a
// bare number may be one of another kind.
typedef enum NumberFit { NUMBER_UNKNOWN, NUMBER_SAME, NUMBER_OTHER } NumberFit;
NumberFit fits_number(const Worksheet *worksheet, const Participant *participant,
                      const char *number);

// Is this the entry "Participant_12_..." of "Participant 12", or one called so in full?
int fits_as_numbered(const Worksheet *worksheet, const Participant *participant,
                     const Entrant *entrant);

// Beside a number that is the same: is it the name, were it not for letters that a zip program has
// mangled (CP437, CP850)?
int fits_mangled_name(const Worksheet *worksheet, const Participant *participant, const char *name);

// Is it the name behind that of a team, "Team A-Ada Lovelace"? Returns the length of the team's
// name, or 0.
size_t fits_behind_team(const Worksheet *worksheet, const Participant *participant,
                        const char *name);

// Has the submitter this e-mail address, this number of the university or this login?
int fits_key(const Worksheet *worksheet, const Participant *participant, const Member *member);

// Are these the participant's names and login, "Lovelace_Ada_ada", as ILIAS has them in one,
// perhaps in ASCII (ilias.h), and VPL with blanks? Any of them may have underscores.
int fits_name_with_login(const Worksheet *worksheet, const Participant *participant,
                         const Member *member);

// Of a participant without any of the submitter's keys: is one given on both sides, and differs?
// The login is no such key, as a list may hold one of another system.
int fits_other_key(const Worksheet *worksheet, const Participant *participant,
                   const Member *member);

// Does a name, which fits no line, look like that of this one?
int looks_like_participant(const Worksheet *worksheet, const Participant *participant,
                           const char *name);

// Are all e-mail addresses of the list of one domain?
int has_one_domain(const Worksheet *worksheet);

// Is this line about no person? Canvas has one with the most points of each column.
int is_no_person(const Worksheet *worksheet, const Participant *participant);

#endif
