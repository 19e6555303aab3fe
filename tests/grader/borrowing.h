// Does an answer to one task call the function that another task asks for?
#ifndef GRADER_BORROWING_H
#define GRADER_BORROWING_H

#include "manifest.h"

// Beside our solution of the other tasks, an answer could have one of them do its work: of two ways
// to intersect a sphere, one is easily the other. Some calls belong there, and our own answer makes
// them too; all others are borrowed.
//   answer   what stands in the student's hole of the task
// Returns the other task, or NULL when nothing is borrowed. Reads the lab's solution, from the
// course's top folder.
const Task *borrowed_task(const Manifest *manifest, const Task *task, const char *answer);

#endif
