// Trying the answer to one task alone, so that one mistake costs one task.
//
// The files are the student's own, so that a helper beside the marked lines counts, with the other
// tasks' answers taken out; or those that are handed out, with this answer in its hole. Beside a
// kernel the host files are those that are handed out in either case, as the student's could draw
// for it. Nothing of our solution is where a student's code runs. What the answer needs of other
// tasks is done by stubs, which do something else than is asked of students and which the judge
// can foresee (tests/stubs/). What comes out of such a run: tests/attacks/README.md.
#ifndef GRADER_ALONE_H
#define GRADER_ALONE_H

#include "session.h"

// Make a variant with one task's answer and a job of its own.
//   answer   what goes into its hole
//   own      the folder of the student's files, or NULL: those that are handed out
// Sets variant->is_changed where a file of the student's differs in more than its answers. Returns
// 0, or -1 after one message.
int alone_fill(Session *session, const char *name, const Task *task, const char *answer,
               const char *own, Variant *variant);

#endif
