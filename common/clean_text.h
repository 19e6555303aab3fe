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

// A message of one or more lines; newlines and tabs stay, trailing newlines go. Each byte of what
// cannot be shown becomes \xHH. NULL counts as "". Owned by the caller; ends the program when
// memory runs out.
char *message_clean(const char *message);

// The same for what must be one line (a path, a device's name): newlines and tabs become spaces.
char *line_clean(const char *line);

// What becomes of newlines and tabs.
typedef enum TextForm {
    TEXT_IN_LINES,   // they stay
    TEXT_IN_A_LINE,  // they become spaces
    TEXT_QUOTED,     // they are shown as bytes, as a name or a wrong number must be seen as it is
} TextForm;

// The same without a limit.
char *text_clean(const char *text, TextForm form);

// The same into `clean`, which holds CLEAN_TEXT_GROWTH * strlen(text) + 1 bytes.
enum { CLEAN_TEXT_GROWTH = 4 };
void text_show(const char *text, TextForm form, char *clean);

// Is it a character that is not seen: a control, a mark of no width, one that turns the reading
// direction?
int character_is_unseen(uint32_t character);

#endif
