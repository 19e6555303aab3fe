// A series of measured times, and what is reported of it: the median with the smallest and the
// largest. The median, as single frames are slow for reasons that are none of the kernel's.
#ifndef BENCH_SERIES_H
#define BENCH_SERIES_H

#define SERIES_MAX_ROUNDS 100
#define SERIES_MAX_A_ROUND 20

// Start with {0}.
typedef struct Series {
    double ms[SERIES_MAX_ROUNDS * SERIES_MAX_A_ROUND];
    int n;
    double round_median_ms[SERIES_MAX_ROUNDS];
    int n_rounds;
    int n_before_round;  // times that belong to finished rounds
} Series;

typedef struct Spread {
    double median, min, max;
} Spread;

// Add a time; at most SERIES_MAX_A_ROUND of them a round.
void series_add(Series *series, double ms);

// End a round: the times since the last one are its own. Does nothing when there are none.
void series_end_round(Series *series);

// Of n numbers, n > 0; they are left as they are.
Spread spread_of(const double *numbers, int n);

// The median of a series with times in it.
double series_median(const Series *series);

// The one of n series whose median is the smallest; those without times do not count, and 0 where
// none has any.
int series_quickest(const Series *series, int n);

// The ratio of two series that were measured in the same rounds, and how far it varies from round
// to round: the median and the spread of the ratios of the rounds' medians. There must be one.
// The ratio of the medians of all rounds is another figure, and may lie outside of that spread.
Spread series_ratio(const Series *dividend, const Series *divisor);

#endif
