// One message for the user (see complain.h).
//
// Read next: clean_text.c.
#include "complain.h"

#include "clean_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define LEFT_OUT " [... left out ...] "

enum {
    LONGEST_MESSAGE = 8000,  // two paths of the longest kind, nearly
    // A longer one holds a long name. It loses its middle, as the reason stands at its end.
    HEAD_BYTES = 4000,
    TAIL_BYTES = 3900,
};

_Static_assert(HEAD_BYTES + sizeof LEFT_OUT + TAIL_BYTES <= LONGEST_MESSAGE + 1,
               "a shortened message fits");

// Put the last bytes of a message of `length` bytes behind the first ones, which `text` holds.
// Where there is no memory for the whole, `text` stays as it is.
static void tail_keep(char *text, size_t length, const char *format, va_list arguments)
{
    char *whole = malloc(length + 1);
    if (whole == NULL) {
        return;
    }
    vsnprintf(whole, length + 1, format, arguments);
    snprintf(text + HEAD_BYTES, LONGEST_MESSAGE + 1 - HEAD_BYTES, LEFT_OUT "%s",
             whole + length - TAIL_BYTES);
    free(whole);
}

void complain(const char *format, ...)
{
    char text[LONGEST_MESSAGE + 1];
    char clean[CLEAN_TEXT_GROWTH * LONGEST_MESSAGE + 1];
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    if (length > LONGEST_MESSAGE) {
        tail_keep(text, (size_t)length, format, again);
    }
    va_end(again);
    va_end(arguments);
    text_show(text, TEXT_IN_A_LINE, clean);
    fprintf(stderr, "%s\n", clean);
}
