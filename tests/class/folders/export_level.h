// Is what was given the folder of an export, or one above or below it?
#ifndef CLASS_EXPORT_LEVEL_H
#define CLASS_EXPORT_LEVEL_H

#include "export.h"

// The folder to go on with, if the entries that were read are not the students': the only folder,
// or the lab's of several exercises. Returns 1 with its path in `inner`, 0 to stay, or -1 after one
// message if it is not clear which exercise is the lab's.
int export_level_find(const Export *export, int lab_number, char inner[PATH_MAX]);

// Is it one of a lab's files? Then the folder of one student was given, and not that of a class.
int export_is_source(const char *name);

#endif
