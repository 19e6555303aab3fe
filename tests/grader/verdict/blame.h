// Finding whose fault it is that a check failed in which answers to several tasks have a part.
//
// In the whole submission a wrong answer to one task fails checks of others, too: those of who
// calls it, and those of what comes of all answers together. A cause or a hint there would send the
// student to a task that may be right.
#ifndef GRADER_BLAME_H
#define GRADER_BLAME_H

#include "result.h"
#include "verdict.h"

// Has the answer to another task a part in this check, and has any?
int check_needs(const Check *check, const char *task);
int check_needs_others(const Check *check);

// For each failed check that needs other tasks' answers: when one of those is wrong for certain,
// take the cause out of the message. Where it is known that this one has a part in it, it is named:
// where the check passes alone, and no other answer that it needs is wrong. A check whose answer
// could not be tried alone then waits for it: it is no failure.
//   checks[result->n_checks]   the judge's, in the result's order
void blame_others(const Check *checks, Result *result);

#endif
