// The text that a compiler reads of an answer: without what stands in `#if 0`.
#ifndef COPIES_LIVE_TEXT_H
#define COPIES_LIVE_TEXT_H

// How much of a text there is to compare, in words.
typedef struct LiveCount {
    int n_left_out;     // in branches that are never compiled
    int n_conditional;  // in branches of other conditions, which are kept, all of them
} LiveCount;

// A copy of the answer with empty lines for what no compiler reads: what follows `#if 0`, or an
// `#else` or `#elif` behind `#if 1`. Lines keep their numbers. free() it. Running out of memory
// ends the program.
char *live_text(const char *answer, LiveCount *count);

#endif
