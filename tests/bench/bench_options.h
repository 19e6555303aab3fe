// The command line of the benches: all take the same options.
//
// Read next: rounds.h.
#ifndef BENCH_BENCH_OPTIONS_H
#define BENCH_BENCH_OPTIONS_H

#include "option_table.h"

typedef struct BenchOptions {
    const char *bench;   // its name, "bench2d"
    const char *device;  // or NULL
    const char *folder;  // where the CSV file goes
    int n_rounds;        // 1 to 100
    int help;            // answered by bench_options_read()
} BenchOptions;

// Read the command line of the bench `name` ("bench2d").
//   what   for --help: "measures this and that"
// The output's folder is made here. Ends the program after the help, or with EXIT_FAILURE after one
// message.
BenchOptions bench_options_read(int argc, char **argv, const char *name, const char *what);

#endif
