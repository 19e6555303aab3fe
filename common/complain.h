// One message for the user, on stderr.
//
// At any step something may be wrong. A message often holds a name that somebody else chose;
// whatever is in it, the message stays one line and nothing in it moves the terminal's cursor. Read
// next: clean_text.h.
#ifndef COMMON_COMPLAIN_H
#define COMMON_COMPLAIN_H

// Print a message made as printf() makes it, and the end of its line. Of more than 8000 bytes the
// middle is left out: a name was too long, and the reason stands at the end. Only that needs memory
// of the heap, as that there is none may be what a message says.
__attribute__((format(printf, 1, 2))) void complain(const char *format, ...);

#endif
