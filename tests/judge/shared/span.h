// Where a number of a right solution in float may lie.
#ifndef JUDGE_SPAN_H
#define JUDGE_SPAN_H

#include <math.h>

typedef struct Span {
    double low, high;
} Span;

static inline int is_within(double t, Span span)
{
    return t >= span.low && t <= span.high;
}

// The smaller and the larger of two such numbers.
static inline Span span_min(Span a, Span b)
{
    return (Span){fmin(a.low, b.low), fmin(a.high, b.high)};
}

static inline Span span_max(Span a, Span b)
{
    return (Span){fmax(a.low, b.low), fmax(a.high, b.high)};
}

#endif
