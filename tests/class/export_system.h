// Which course system made the names in an export.
//
// Whether a system made a name, or a student chose one that looks so, is seen by the other entries:
// a system whose pattern fits more than half of them, and the most, made the folder. Each entry
// counts for every system whose pattern it fits, as the system's own stands before whatever a
// student wrote.
#ifndef CLASS_EXPORT_SYSTEM_H
#define CLASS_EXPORT_SYSTEM_H

#include "export.h"

// The system, or SYSTEM_NONE.
ExportSystem export_system_find(const Export *export);

// Read each name that may be the system's, export->system, as that.
void export_names_read(Export *export);

#endif
