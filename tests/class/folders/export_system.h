// Which course system made the names in an export.
//
// Whether a system made a name, or a student chose one that looks so, is seen by the other entries:
// a system whose pattern fits more than half of them, and the most, made the folder. Each entry
// counts for every system that could have made it, as the system's own stands before whatever a
// student wrote: so all entries count for the system that made them, however many one student has,
// and whatever they are called. And the names must be those of more people than there are folders
// and archives of plain names: into a folder that all can write to, one student may put many files.
#ifndef CLASS_EXPORT_SYSTEM_H
#define CLASS_EXPORT_SYSTEM_H

#include "export.h"

// The system, or SYSTEM_NONE.
ExportSystem export_system_find(const Export *export);

// How many folders and archives have names that the system has not made. *first: one of them.
int export_plain_count(const Export *export, ExportSystem system, const Found **first);

// Say what ILIAS does not say of teams, where there are any.
void export_teams_tell(const Export *export);

// Read each name that may be the system's, export->system, as that.
void export_names_read(Export *export);

#endif
