// Rounds of a bench (see rounds.h).
//
// Read next: measurements.c.
#include "rounds.h"

#include "stats.h"

#include <stdio.h>

int rounds_run(MeasureRound *measure, void *bench, const BenchOptions *options,
               double longest_seconds, const char *first_is_done)
{
    Measurements measurements = {0};
    if (measurements_open(&measurements, options->folder, options->bench) != 0) {
        return -1;
    }
    const double start = stats_clock_ms();
    double seconds = 0;
    for (int round = 0; round < options->n_rounds; round++) {
        const double seconds_before = seconds;
        measurements.round = round;
        if (measure(bench, &measurements) != 0) {
            return measurements_close(&measurements, -1);
        }
        seconds = (stats_clock_ms() - start) / 1e3;
        printf("round %d of %d done after %.0f s%s\n", round + 1, options->n_rounds, seconds,
               round == 0 ? first_is_done : "");
        fflush(stdout);
        if (round + 1 < options->n_rounds && 2 * seconds - seconds_before > longest_seconds) {
            printf("no further round: this machine would take too long\n");
            break;
        }
    }
    return measurements_close(&measurements, 0);
}
