// Writing bytes to an open file, all of them.
#ifndef GRADER_BYTES_WRITE_H
#define GRADER_BYTES_WRITE_H

#include <stddef.h>

// Returns 0, or -1 with errno set when not all could be written.
int bytes_write(int descriptor, const void *bytes, size_t n_bytes);

#endif
