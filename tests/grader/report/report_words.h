// What the reports for other systems say in words. Each returns a text of any content, to be
// cleaned where it is written; free() it.
#ifndef GRADER_REPORT_WORDS_H
#define GRADER_REPORT_WORDS_H

#include "manifest.h"
#include "result.h"

// "85 of 100 points".
char *points_words(int points, int max_points);

// How the submission as a whole went: each stage that failed or has something to say, "" for none.
char *stages_words(const Result *result);

// The hint that stands under a failed check; "" where it passed, or where a message of its task has
// said why, or another task is at fault: then one about something else would only mislead. Lives as
// long as the manifest.
const char *check_hint(const Manifest *manifest, const Result *result, const CheckResult *check);

// The hint of a task: that of its first failed check, or "".
const char *task_hint(const Manifest *manifest, const Result *result, const Task *task);

// A check's message, and under a failed one its hint; "" when it passed.
char *check_words(const Manifest *manifest, const Result *result, const CheckResult *check);

// The first stage that failed, or NULL.
const StageResult *failed_stage(const Result *result);

#endif
