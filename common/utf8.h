// Characters of UTF-8, one at a time.
//
// For what looks at text of unknown origin: clean_text.c, and the names of students.
#ifndef COMMON_UTF8_H
#define COMMON_UTF8_H

#include <stdint.h>

// Read the character at `text`, which ends with a NUL. Returns its length in bytes, or 0 and leaves
// *character alone when it is none: broken off, longer than needed, half of a surrogate pair or
// beyond U+10FFFF. A NUL is a character of one byte.
// Source: RFC 3629, "UTF-8, a transformation format of ISO 10646", section 4.
int utf8_read(const char *text, uint32_t *character);

// Does a character go on with this byte? Those that do not begin one: a column each, in most text.
int utf8_goes_on(char byte);

#endif
