// When an attempt was handed in, by what the course system has written about it.
#ifndef CLASS_ENTRY_TIME_H
#define CLASS_ENTRY_TIME_H

#include "export.h"

// The time of an attempt as a text for moment_read(), "" where the export says none: Blackboard and
// Brightspace have it in the names of files, Gradescope in its list, ILIAS before each file's name
// in the student's folder, where the last one counts, Stud.IP
// in its list of files. Owned, free() it; NULL when memory runs out.
//   time_from   out: by which row of the table in evidence.h; SYSTEM_NONE: there is no time
char *entry_time(const Export *export, const Found *found, ExportSystem *time_from);

// Did the system mark the attempt as late? Canvas does in the names of files, a newer ILIAS, which
// writes no times, before the name of each file in the student's folder.
int entry_is_late(const Export *export, const Found *found);

#endif
