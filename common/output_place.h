// Where a file may be made, found out before the work and not after it.
//
// Flow: scene -> buffers -> kernel -> IMAGE -> comparison. Read next: output_file.h: it makes it.
#ifndef COMMON_OUTPUT_PLACE_H
#define COMMON_OUTPUT_PLACE_H

// What was expected where no file can be made at `path`, for a message: "a file, not a folder"; or
// NULL where one can be.
const char *output_place_expected(const char *path);

// Do two paths name one entry of one folder? A file that is saved takes the place of an entry, so
// this holds for any spelling of the paths, whether or not there is a file yet.
int output_place_is_same(const char *left, const char *right);

#endif
