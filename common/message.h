// Messages for students, made like printf makes them.
#ifndef GRADER_MESSAGE_H
#define GRADER_MESSAGE_H

#include <stddef.h>

// A new message; free() it. Running out of memory ends the program.
__attribute__((format(printf, 1, 2))) char *message_new(const char *format, ...);

// The end of a noun after a number: "" for one, "s" for any other.
const char *plural(unsigned n);

// Text that a student chose (a file's name, a folder's path) made fit for a message: printable
// ASCII only, what else there is becomes '?', and of one that is too long the middle is left out.
// Returns `shown`, which holds n_bytes bytes, at least 16.
enum { MESSAGE_SHOWN_BYTES = 124 };  // enough for a name
char *message_show(const char *text, char *shown, size_t n_bytes);

// What stands between what was found and the sentence that names the mistake, in a judge's message:
// "found 1, expected 0; the shorter side was split". Nothing else in it has a semicolon.
#define MESSAGE_CAUSE "; "

// Does a judge's message say why, so that no hint need follow?
int message_names_cause(const char *message);

#endif
