// Judging one function's answers in one range of lab 07's inputs.
#ifndef GRADER_JUDGE_07_RANGE_H
#define GRADER_JUDGE_07_RANGE_H

#include "judge_07.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// How far t may be off that a right solution computes for a plane, in units of (|plane| + |origin|)
// / |direction|: one rounding for the difference, five for the division (2.5 ulp, OpenCL 1.2, 7.4)
// or the inverse, one for the product, and the same once more where both terms are multiplied
// before they are subtracted.
#define PLANE_ERROR (16 * 0x1p-24)

// Where a number of a right solution may lie.
typedef struct Span {
    double low, high;
} Span;

static inline int is_within(double t, Span span)
{
    return t >= span.low && t <= span.high;
}

// Does an answer agree with what comes of known mistake number `mistake`, 0 for none?
typedef int Agrees(const Inputs07 *inputs, int i, const void *answers, int mistake);

// The answers of one function in one range.
typedef struct Range {
    const Inputs07 *inputs;
    const void *answers;
    size_t answer_bytes;
    int first, n;
    Agrees *agrees;
    const char *const *mistakes;  // what is said about each; that of number 0 is not used
    int n_mistakes;
} Range;

typedef struct Wrong {
    int n;            // wrong answers
    int first;        // the first wrong input
    const char *why;  // the mistake that explains all of them; "" when none does
} Wrong;

// Where every answer is the same, as where nothing was filled in, no mistake is looked for.
Wrong range_judge(const Range *range);

#endif
