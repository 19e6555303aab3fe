// The files that a sandboxed command may open, as rules for Landlock: a process gives up the right
// to open files, but for those it names first.
#ifndef GRADER_LANDLOCK_H
#define GRADER_LANDLOCK_H

#include "sandbox_walls.h"

// In the process that becomes the command: from here on it and all that it will start open only
// what the walls name. Needs PR_SET_NO_NEW_PRIVS. Returns 0, or -1 with errno set.
int landlock_rules_enter(const Walls *walls);

#endif
