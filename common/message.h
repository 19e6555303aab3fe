// Messages for students, made like printf makes them.
#ifndef GRADER_MESSAGE_H
#define GRADER_MESSAGE_H

#include <stdarg.h>
#include <stddef.h>

// A new message; free() it. Running out of memory ends the program.
__attribute__((format(printf, 1, 2))) char *message_new(const char *format, ...);
__attribute__((format(printf, 1, 0))) char *message_new_from(const char *format, va_list arguments);

// The end of a noun after a number: "" for one, "s" for any other.
const char *plural(unsigned n);

// Text that a student chose (a file's name, a folder's path) made fit for one line of a message
// (clean_text.h); of one that is too long the middle is left out. Returns `shown`, which holds
// n_bytes bytes, at least 16.
enum { MESSAGE_SHOWN_BYTES = 124 };  // enough for a name
char *message_show(const char *text, char *shown, size_t n_bytes);

#endif
