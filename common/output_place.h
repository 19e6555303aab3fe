// Where a file is to be written: found out before the work and not after it.
//
// It is asked as soon as the command line is read. Read next: output_file.h, which writes it.
#ifndef COMMON_OUTPUT_PLACE_H
#define COMMON_OUTPUT_PLACE_H

// Can a file be made at `path`, or the one that is there be replaced? Returns NULL, or what was
// expected instead: "a file in a folder that exists".
const char *output_place_fault(const char *path);

// Do two paths name one entry of one folder? A file that is saved takes the place of an entry, so
// this holds for any spelling of the paths, whether or not there is a file yet. Returns 1 or 0.
int output_place_is_same(const char *left, const char *right);

#endif
