// The hints that stand below what failed. Both live as long as the manifest.
#ifndef GRADER_HINTS_H
#define GRADER_HINTS_H

#include "manifest.h"
#include "result.h"

// The hint of a failed check: its own, or that of the check whose message has named what is wrong
// with the task. "" where it did not fail, where its own message says why, or where another task is
// at fault: then one about something else would only mislead.
const char *check_hint(const Manifest *manifest, const Result *result, const CheckResult *check);

// The hint of a task: that of its first failed check, or "".
const char *task_hint(const Manifest *manifest, const Result *result, const Task *task);

#endif
