// By which law does a quantity grow with the number of elements, a time or a count? A law is fitted
// to it, and how far it stays from that says whether it is its own.
//
// Read next: report_builds.h.
#ifndef BENCH_GROWTH_H
#define BENCH_GROWTH_H

typedef enum Law {
    N_LOG_N,  // a N log2 N + b N: with twice the number an element costs a more
    LINEAR,   // b N: an element costs the same however many there are
} Law;

typedef struct Growth {
    double a;  // 0 where LINEAR
    double b;
    double deviation;  // the largest of a quantity's from what is fitted, as a share of the first
} Growth;

// Fit a law to quantities: the sum of the squares of their relative deviations is the smallest.
// Relative, as else the largest quantities alone would count.
//   elements[n]     from 1 on, no two the same; there are two or more
//   quantities[n]   above 0
Growth growth_fit(Law law, const double *elements, const double *quantities, int n);

// What the fitted law says of a number of elements.
double growth_at(Growth growth, double elements);

#endif
