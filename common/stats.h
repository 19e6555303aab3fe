// Figures of a run: collected by main.c, printed as text, written as JSON (--stats FILE).
//
// What a run cost. Read next: lab.h and work_stats.h, which fill it.
#ifndef COMMON_STATS_H
#define COMMON_STATS_H

#include <stdint.h>

// An ordered list of named figures; start with {0}.
typedef struct Stats {
    struct json_t *values;
} Stats;

// Add a figure; a name given twice keeps the later value. Numbers that are not finite are written
// as null. Running out of memory ends the program with a message.
void stats_text(Stats *stats, const char *name, const char *value);
void stats_integer(Stats *stats, const char *name, int64_t value);
void stats_number(Stats *stats, const char *name, double value);

// Sort n > 0 numbers and return their median: the middle one, or the mean of the middle two. The
// smallest is then the first and the largest the last.
double stats_median(double *numbers, int n);

// Room for n times that are still to be measured; free() it. Running out of memory ends the program
// with a message.
double *stats_times_create(int n);

// Add min, median and max of n measured milliseconds as name.min_ms, name.median_ms and
// name.max_ms; sorts the array. Nothing is added for n < 1.
void stats_milliseconds(Stats *stats, const char *name, double *milliseconds, int n);

// Print every figure, one "name  value" a line, and write them to `path` as one JSON object unless
// path is NULL. The file appears whole or not at all. Returns 0, or -1 after one message on stderr.
int stats_report(const Stats *stats, const char *path);

// Release; a zeroed Stats is fine.
void stats_free(Stats *stats);

// A clock for measuring, in milliseconds since some fixed moment.
double stats_clock_ms(void);

#endif
