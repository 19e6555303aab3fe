// Who of Moodle's list an entry of the gradebook belongs to: one student, or all of a team.
//
// What the instructor has decided (decisions.h) comes first. For the rest points must never reach
// anybody else. So what fits two, or fits one but for a part that differs, is entered for nobody,
// and listed for the instructor.
//   - Where the export says more of a submitter than a name, the entry belongs to each of them:
//     Gradescope gives e-mail addresses and university numbers; Canvas, Brightspace and ILIAS their
//     own numbers or logins. Whose key it is, else whose name, unless the list gives that person
//     another key of the kind. A number or login of one and the name of another are nobody's.
//   - A team of ILIAS' belongs to the group of its name, else to those whose folders are in it: who
//     else is in the team nobody knows, so of nobody it is said that nothing was handed in.
//   - Another entry belongs to the team of its name, where the list has a column of groups, or to
//     whom its name fits: a full name, user name, number or e-mail address; or the part before the
//     @, if all addresses of the list are of one domain. A name written as one, "lovelaceada", may
//     be somebody's login (Blackboard has no names): it is nobody's.
//   - Attempts are one student's only where Moodle's export says so (roster.h): "carol-2" is nobody
//     but a participant of that name.
//   - Of several versions of one file (versions.h) none counts until the instructor says which one.
//   - Moodle's number of an entry parts two of one name, and stands for a person alone only as
//     "Participant 12". A team's numbers are not those of the list.
#ifndef CLASS_OWNERS_H
#define CLASS_OWNERS_H

#include "worksheet.h"

// Fill in the participants' rows and worksheet->entered. Returns 0, or -1 when memory runs out.
int owners_find(Worksheet *worksheet, const Gradebook *gradebook);

#endif
