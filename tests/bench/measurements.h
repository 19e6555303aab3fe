// What a bench has measured: one CSV file, a row a value. The benches calculate nothing: medians,
// ratios, tables and plots are made of these files by tables.sh.
//
// Read next: tables.sql.
#ifndef BENCH_MEASUREMENTS_H
#define BENCH_MEASUREMENTS_H

#include "output_file.h"

typedef struct Measurements {
    OutputFile output;
    int round;  // whose values are added
} Measurements;

// Begin FOLDER/BENCH.csv. Its columns:
//     scene, what       "sphereflake", "kd-tree": what was measured; `what` is empty if a value is
//                       of the scene alone
//     quantity          "frame", "build", ...: times are milliseconds
//     round, value      a round may have several values of one quantity
// Returns 0, or -1 after one message. End it with measurements_close().
int measurements_open(Measurements *measurements, const char *folder, const char *bench);

// Add a value. The texts contain no quotation mark.
void measurements_add(Measurements *measurements, const char *scene, const char *what,
                      const char *quantity, double value);

// Write the file if `result`, that of the measuring, is 0; otherwise there is no file.
// Returns 0 if it is written, or -1.
int measurements_close(Measurements *measurements, int result);

#endif
