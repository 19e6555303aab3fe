// What the judge may use: answers over which it computes for long, or fills the memory, were made
// for that. It ends over them, and they are wrong (grader/verdict/judge_process.c).
#ifndef JUDGE_JUDGE_LIMITS_H
#define JUDGE_JUDGE_LIMITS_H

#include <stddef.h>

// No probe's answers take so long to judge, in seconds of processor time for all that is asked of
// them, nor so much memory, in bytes.
enum { MOST_SECONDS = 20 };
#define MOST_BYTES ((size_t)2 << 30)

// From now on count processor time from 0: after that many seconds SIGPROF ends the program.
void limit_time(int seconds);

// From now on memory beyond this is not there. A sanitizer reserves far more: under one there is no
// limit.
void limit_memory(size_t n_bytes);

#endif
