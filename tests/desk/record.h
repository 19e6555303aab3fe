// progress.json in the course's top folder: what a student has reached, lab by lab.
//
//     { "03-kdtree-2d-render": {
//           "when": "2026-11-26 22:41", "score": 60, "best": 75, "max_score": 100,
//           "tasks": { "getContainingChild": 25, "descent": 35, "leaf_loop": 0 },
//           "task": "leaf_loop", "check": "leaf-random", "hints": 2 } }
//
// `task` and `check` are the fault of the last grading that hints are about (results.h), and
// `hints` says how many of its hints were shown. Nothing but the desk reads the file; a student may
// delete it.
#ifndef DESK_RECORD_H
#define DESK_RECORD_H

#include <jansson.h>

#define RECORD_PATH "progress.json"

// The whole record, empty where there is no file yet; json_decref() it. NULL after one message.
json_t *record_load(void);

// Write it, whole or not at all, and release it. Returns 0, or -1 after one message.
int record_save(json_t *record);

// Note what a grading found. The hints that were shown count on while the fault stays the same.
// Returns 0, or -1 after one message.
int record_note(const json_t *results);

#endif
