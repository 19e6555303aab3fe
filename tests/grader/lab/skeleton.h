// The files of a lab as they are handed out, whatever a student has made of labs/ meanwhile.
#ifndef GRADER_SKELETON_H
#define GRADER_SKELETON_H

#include "manifest.h"

#include <stdint.h>

// One of the lab's files as it is handed out: cut from the solution, or in a handout, which has
// none, read from tests/skeletons/NN-name/. Returns the text, free() it, or NULL after one message
// on stderr.
char *skeleton_read(const Manifest *manifest, const char *file);

// What a task's hole holds as it is handed out. Free() it. NULL where there is none.
char *placeholder_read(const Manifest *manifest, const Task *task);

// What stands in the hole of a task while another one is tried alone (tests/stubs/README.md).
//   nonce   the number that is written for each NONCE in it
// Returns the text, free() it, or NULL where the hole stays as it is handed out.
char *stub_read(const Manifest *manifest, const Task *task, uint32_t nonce);

#endif
