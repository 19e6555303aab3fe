// Rounds: everything is measured in turn, then all of it again, so that what else the machine does
// falls on all cases: trust the ratios more than the milliseconds.
//
// Read next: measurements.h.
#ifndef BENCH_ROUNDS_H
#define BENCH_ROUNDS_H

#include "bench_options.h"
#include "measurements.h"

// Measure everything once, and add it to the measurements. In their round 0 the results are
// compared, too. Returns 0, or -1 after one message.
typedef int MeasureRound(void *bench, Measurements *measurements);

// Measure for as many rounds as the options say, print after each how long it has taken, and write
// the measurements.
//   longest_seconds   no further round begins that would end later
//   first_is_done     what the first round has shown: "; all pictures are equal"
// Returns 0, or -1 after one message: there is no file then.
int rounds_run(MeasureRound *measure, void *bench, const BenchOptions *options,
               double longest_seconds, const char *first_is_done);

#endif
