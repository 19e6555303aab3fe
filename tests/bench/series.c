// A series of measured times (see series.h).
#include "series.h"

#include "stats.h"

#include <string.h>

void series_add(Series *series, double ms)
{
    series->ms[series->n++] = ms;
}

void series_end_round(Series *series)
{
    const int n = series->n - series->n_before_round;
    if (n > 0) {
        const double *round_ms = series->ms + series->n_before_round;
        series->round_median_ms[series->n_rounds++] = spread_of(round_ms, n).median;
        series->n_before_round = series->n;
    }
}

Spread spread_of(const double *numbers, int n)
{
    double sorted[SERIES_MAX_ROUNDS * SERIES_MAX_A_ROUND];
    memcpy(sorted, numbers, (size_t)n * sizeof *sorted);
    const double median = stats_median(sorted, n);
    return (Spread){median, sorted[0], sorted[n - 1]};
}

double series_median(const Series *series)
{
    return spread_of(series->ms, series->n).median;
}

int series_quickest(const Series *series, int n)
{
    int quickest = 0;
    for (int i = 1; i < n; i++) {
        if (series[i].n > 0 && (series[quickest].n == 0 ||
                                series_median(&series[i]) < series_median(&series[quickest]))) {
            quickest = i;
        }
    }
    return quickest;
}

Spread series_ratio(const Series *dividend, const Series *divisor)
{
    double ratios[SERIES_MAX_ROUNDS] = {0};
    for (int i = 0; i < dividend->n_rounds; i++) {
        ratios[i] = dividend->round_median_ms[i] / divisor->round_median_ms[i];
    }
    return spread_of(ratios, dividend->n_rounds);
}
