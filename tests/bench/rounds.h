// Rounds: everything is measured in turn, then all of it again, so that what else the machine does
// falls on all cases: trust the ratios more than the milliseconds.
//
// Read next: series.h.
#ifndef BENCH_ROUNDS_H
#define BENCH_ROUNDS_H

// Measure everything once. `round` counts from 0. Returns 0, or -1 after one message.
typedef int MeasureRound(void *bench, int round);

// Measure for n_rounds, and print after each how long it has taken.
//   longest_seconds   no further round begins that would end later
//   first_is_done     what the first round has shown: "; all pictures are equal"
// Returns 0, or -1 after one message.
int rounds_run(MeasureRound *measure, void *bench, int n_rounds, double longest_seconds,
               const char *first_is_done);

#endif
