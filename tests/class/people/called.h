// Who is meant by a name that the instructor wrote into a list.
//
// Only the same name counts, to the byte, so that it never means somebody who chose a name like it.
// Read next: corrections.h, decisions.h.
#ifndef CLASS_CALLED_H
#define CLASS_CALLED_H

#include "worksheet.h"

// What a name stands for. Of several the first and the last one are kept, for a message.
typedef struct Called {
    int n;
    int first, last;
} Called;

// The rows that a student's name, number, slug or e-mail address stands for, also that of a team's
// member: indices into gradebook->rows. Attempts of one student are one row, the one that counts.
//   worksheet   the list of participants: its names, numbers and addresses count, too; or NULL
Called called_student(const Gradebook *gradebook, const Worksheet *worksheet, const char *name);

// The rows whose entry has this name ("entry" in gradebook.json) or slug.
Called called_entry(const Gradebook *gradebook, const char *name);

// The lines of a list of participants whose name, user name, number or address it is: indices into
// worksheet->participants.
Called called_participant(const Worksheet *worksheet, const char *name);

#endif
