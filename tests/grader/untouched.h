// Answers that are not there.
#ifndef GRADER_UNTOUCHED_H
#define GRADER_UNTOUCHED_H

#include "manifest.h"

// Does the answer to a task stand as it is handed out, comments and blanks aside? The folder labs/
// is not asked: a student may be at work there.
int answer_is_untouched(const Manifest *manifest, const Task *task, const char *answer);

// Does an answer begin with the placeholder's `return ...;`, so that nothing below it runs?
int answer_returns_as_handed_out(const Manifest *manifest, const Task *task, const char *answer);

#endif
