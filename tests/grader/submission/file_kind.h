// What a file that is no archive seems to be, for the message to the student who handed it in.
#ifndef GRADER_FILE_KIND_H
#define GRADER_FILE_KIND_H

#include <stddef.h>

// By the first bytes of the file, some hundred: "a RAR archive", "a single text file".
const char *file_kind(const unsigned char *bytes, size_t n_bytes);

#endif
