// What a submission must not read, and a sandbox that goes by the rights of files cannot hide.
#ifndef GRADER_SECRETS_H
#define GRADER_SECRETS_H

#include "settings.h"

// As root: are the course with its solutions, the folder of the submission (others' lie beside it)
// and the graders' own folders closed to a user who has no rights here? Returns 0, or -1 after one
// message on stderr that says what to close, and how.
int secrets_check(const Settings *settings);

#endif
