// Judging a function of the student's: a range of inputs for each check, an answer for each input.
#ifndef JUDGE_FUNCTION_H
#define JUDGE_FUNCTION_H

#include "known.h"
#include "sections.h"
#include "verdicts.h"

#include <stddef.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// Inputs or scenes first, first + step, ... , n of them; a step of 0 is 1.
typedef struct Range {
    int first, n, step;
} Range;

// Number i of ranges that follow one another, each of n inputs.
#define RANGE(i, n) {(i) * (n), n}

// Number i of a range.
int range_at(Range range, int i);

// Of n inputs the last n_edges are the same in every job. Which of these is number i, from 0 on?
// Returns -1 for an input that is rolled.
int edge_of(int i, int n, int n_edges);

enum { MOST_KNOWN_LISTS = 4 };

typedef struct Function {
    const char *section;  // of the answers
    int n;                // how many there are in all ranges together
    size_t answer_bytes;  // of one
    size_t inputs;        // offset in the job: the functions below get what begins there as `job`

    // Is answer number i right? A wrong one is described, "...: found 1, expected 2", owned by the
    // caller; how many are wrong is counted.
    int (*is_right)(const void *job, int i, const void *answers);
    char *(*describe)(const void *job, int i, const void *answers);
    const char *counted;  // "points"; NULL for "inputs"

    // The known mistakes (known.h), in one list or more. The cause is one that explains every
    // answer, in the ranges of other checks, too: else it is not what the function does.
    KnownList *known[MOST_KNOWN_LISTS];
    int is_known_by_range;  // a check's range is enough: what a mistake makes of the other ranges
                            // is lost in rounding, or undefined
    // Of answers that are all the same nothing is concluded, but where some mistake of the list
    // makes them so.
    int knows_constant;
} Function;
#define KNOWING(right, words, ...) .is_right = (right), .describe = (words), .known = {__VA_ARGS__}

// Are there no facts, so that the answer is right? Releases them.
int facts_are_none(char *facts);

// The function's answers, or NULL when they are missing.
const void *function_answers(const Function *function, const Sections *answers);

// Judge the answers to a range of inputs: the diagnosis is of the first wrong one.
Verdict function_judge(const Function *function, const void *job, Range range,
                       const Sections *answers);

// The known mistake that explains the answers to a range, not all of which are right, if one does.
Cause function_cause(const Function *function, const void *job, Range range,
                     const Sections *answers);

#endif
