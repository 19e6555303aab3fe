// Fitting a law of growth (see growth.h).
//
// Read next: report_builds.c.
#include "growth.h"

#include <math.h>

double growth_at(Growth growth, double elements)
{
    return (growth.a * log2(elements) + growth.b) * elements;
}

Growth growth_fit(Law law, const double *elements, const double *quantities, int n)
{
    // The sum of (a x + b y - 1)^2, with x = N log2 N / quantity and y = N / quantity, is smallest
    // where both its derivatives are 0: a xx + b xy = x and a xy + b yy = y, all of them sums.
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int i = 0; i < n; i++) {
        const double linear = elements[i] / quantities[i];
        const double n_log_n = linear * log2(elements[i]);
        x += n_log_n;
        y += linear;
        xx += n_log_n * n_log_n;
        xy += n_log_n * linear;
        yy += linear * linear;
    }
    Growth growth = {0};
    if (law == N_LOG_N) {
        growth.a = (x * yy - y * xy) / (xx * yy - xy * xy);
    }
    growth.b = (y - growth.a * xy) / yy;
    for (int i = 0; i < n; i++) {
        const double share = growth_at(growth, elements[i]) / quantities[i];
        growth.deviation = fmax(growth.deviation, fabs(share - 1));
    }
    return growth;
}
