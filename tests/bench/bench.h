// What all benches share: the command line, rounds, and the CSV file of what was measured.
//
// In a round everything is measured in turn, then all of it again, so that what else the machine
// does falls on all cases: trust the ratios more than the milliseconds. The benches calculate
// nothing: medians, ratios, tables and plots are made of the CSV files by tables.sh.
// Read next: bench2d.c, tables.sql.
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include "output_file.h"

typedef struct BenchOptions {
    const char *device;  // or NULL
    const char *folder;  // where the CSV file goes
    int n_rounds;        // 1 to 100
    int help;            // answered by bench_run()
} BenchOptions;

typedef struct Measurements {
    OutputFile output;
    int round;  // whose values are added
} Measurements;

// Add a value. The texts contain no quotation mark.
//   scene, what   "sphereflake", "kd-tree": what was measured; `what` is empty if a value is of the
//                 scene alone
//   quantity      "frame", "build", ...: times are milliseconds; a round may have several of one
void measurements_add(Measurements *measurements, const char *scene, const char *what,
                      const char *quantity, double value);

// A bench. Its functions get what bench_run() was given.
typedef struct BenchKind {
    const char *name;           // "bench2d"
    const char *what;           // for --help: "measures this and that"
    double longest_seconds;     // no further round begins that would end later
    const char *first_is_done;  // what the first round has shown: "; all pictures are equal"
    // Everything up to the first frame. Returns 0, or -1 after one message.
    int (*prepare)(void *bench, const BenchOptions *options);
    // Measure everything once. In round 0 the results are compared, too. Returns 0, or -1 after one
    // message.
    int (*measure_round)(void *bench, Measurements *measurements);
    void (*free)(void *bench);  // after a failure too
} BenchKind;

// Read the command line, measure for as many rounds as it says, print after each how long it has
// taken, and write FOLDER/NAME.csv, whose folder is made; there is no file after a fault.
//   bench   zeroed, for the functions of the kind
// Returns the exit status of main().
int bench_run(const BenchKind *kind, int argc, char **argv, void *bench);

#endif
