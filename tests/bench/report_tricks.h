// What the bench of tricks tells, for people and for programs.
//
// Used by bench_tricks.c.
#ifndef BENCH_REPORT_TRICKS_H
#define BENCH_REPORT_TRICKS_H

#include "trick_case.h"

// Print a part's table.
//   cases   of its scenes
void report_tricks_print(const TrickCase *cases, Part part);

// Write FOLDER/bench_tricks.csv, one row a trick and scene:
//     part                 circles or spheres
//     without              the trick that is left out, as its folder in FOLDER/tricks; in the first
//                          row of each part, named as that, none is
//     scene                as --scene takes it
//     median_ms, min_ms, max_ms      a frame
//     ratio, min_ratio, max_ratio    of this time to that with all tricks, single rounds: median,
//                                    spread
// Returns 0, or -1 after one message.
int report_tricks_write_csv(TrickCase cases[N_PARTS][N_TRICK_SCENES], const char *folder);

#endif
