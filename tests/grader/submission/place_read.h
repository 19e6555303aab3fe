// Reading a file that a student handed in, from its place. Used by stage.c and stage_file.c.
#ifndef GRADER_PLACE_READ_H
#define GRADER_PLACE_READ_H

#include "places.h"

#include <sys/types.h>
#include <time.h>

// Open a regular file where it was found below the open folder `top`. Returns a descriptor, or -1
// with errno set: ENXIO where it is something else, ELOOP where it is a link.
int place_file_open(int top, const Place *place);

// Read what an open file holds into bytes[STAGE_MAX_FILE_BYTES + 1]. Returns how much, or -1.
ssize_t place_bytes_read(int descriptor, unsigned char *bytes);

// Both. Returns how many bytes of text are there, or -1 when it is none that could be staged.
//   changed   out: when it was changed last; or NULL
ssize_t place_text_read(int top, const Place *place, unsigned char *bytes, time_t *changed);

#endif
