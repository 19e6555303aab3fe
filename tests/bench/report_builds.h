// What the bench of builds tells: times and memory of each case, and for each builder two laws of
// growth, fitted to its times, with how far the times stay from them.
//
// Read next: bench_builds.gnuplot.
#ifndef BENCH_REPORT_BUILDS_H
#define BENCH_REPORT_BUILDS_H

#include "case_build.h"

// Print the tables. A builder's cases stand one behind the other, from the smallest scene on.
void report_builds_print(const BuildCase *cases, int n_cases);

// Write FOLDER/bench_builds.csv, one row a case:
//     builder, n_elements                  see BUILDERS
//     median_ms, min_ms, max_ms            of all builds
//     law_ms                               what the builder's law says (BUILDERS), fitted to them
//     handed_on, law_handed_on             the same of the elements of all nodes together
//     per_leaf                             elements that a leaf lists, on average
//     bytes_per_element                    of the finished tree
//     peak_bytes_per_element               the most that the builder has asked for at one moment
// Returns 0, or -1 after one message.
int report_builds_write_csv(const BuildCase *cases, int n_cases, const char *folder);

#endif
