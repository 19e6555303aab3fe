// The files that a sandboxed command may open, as rules for Landlock.
#ifndef GRADER_LANDLOCK_RULES_H
#define GRADER_LANDLOCK_RULES_H

#include "sandbox_walls.h"

// In the process that becomes the command: from here on it opens only what the walls name. Returns
// 0, or -1 with errno set.
int landlock_rules_enter(const Walls *walls);

#endif
