// A series of measured times (see series.h).
#include "series.h"

#include <stdlib.h>
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

static int compare_numbers(const void *left, const void *right)
{
    const double a = *(const double *)left;
    const double b = *(const double *)right;
    return (a > b) - (a < b);
}

Spread spread_of(const double *numbers, int n)
{
    double sorted[SERIES_MAX_ROUNDS * SERIES_MAX_A_ROUND];
    memcpy(sorted, numbers, (size_t)n * sizeof *sorted);
    qsort(sorted, (size_t)n, sizeof *sorted, compare_numbers);
    return (Spread){(sorted[(n - 1) / 2] + sorted[n / 2]) / 2, sorted[0], sorted[n - 1]};
}
