// What the 3D bench tells of whole frames with shadows and mirrors: tables for people, a CSV file.
//
// Read next: report_lit.c.
#ifndef BENCH_REPORT_LIT_H
#define BENCH_REPORT_LIT_H

#include "lit_frames.h"

// What tables and messages call the renderers: "kd-tree (lab 09)".
extern const char *const LIT_TITLES[N_LIT_RENDERERS];

// Print all tables.
//   scene_name   whose frames they are
void report_lit_print(const LitFrame frames[N_LIT_FRAMES], const char *scene_name);

// Write FOLDER/bench3d-lit.csv, one row a renderer, size and number of mirrors; fields that mean
// nothing are empty:
//     renderer, scene      kdtree (lab 09's) or tiles, and as --scene takes it
//     side, mirrors        of the picture, pixels; how often a ray is mirrored at most
//     median_ms, min_ms, max_ms, fps    a frame; frames a second at the median
//     ratio, min_ratio, max_ratio       of lab 09's time to this one, single rounds: median, spread
//     different_pixels     from lab 09's picture
// Returns 0, or -1 after one message.
int report_lit_write_csv(const LitFrame frames[N_LIT_FRAMES], const char *scene_name,
                         const char *folder);

#endif
