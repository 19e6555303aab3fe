// Text of unknown origin made fit for messages and reports: a file's name, a compiler's log.
//
// What comes out is valid UTF-8 in which nothing can move a terminal's cursor, turn the reading
// direction or break a JSON string, and it is short enough to be read. It is NOT escaped for HTML:
// html.h does that while writing. Read next: complain.h.
#ifndef COMMON_CLEAN_TEXT_H
#define COMMON_CLEAN_TEXT_H

#include <stdint.h>

// A longer message loses its middle: the first errors matter most, the last lines say how it ended.
enum {
    MESSAGE_MAX_LINES = 40,
    MESSAGE_MAX_BYTES = 8000,
    LINE_MAX_BYTES = 500,
};

// A message of one or more lines; newlines and tabs stay, trailing newlines go. What cannot be
// shown becomes U+FFFD. NULL counts as "". Owned by the caller; ends the program when memory runs
// out.
char *message_clean(const char *message);

// The same for what must be one line (a path, a device's name): newlines and tabs become spaces.
char *line_clean(const char *line);

// What both stand on: write `text` so that all of it can be shown, whatever its length.
//   one_line   newlines and tabs become spaces, too
//   clean      out; holds CLEAN_TEXT_GROWTH * strlen(text) + 1 bytes
enum { CLEAN_TEXT_GROWTH = 3 };
void text_show(const char *text, int one_line, char *clean);

// What is shorter, for quotations: in place, each byte that is no printable ASCII becomes '?'.
void ascii_show(char *text);

// Is it a character that is not seen: a control, a mark of no width, one that turns the reading
// direction?
int character_is_unseen(uint32_t character);

#endif
