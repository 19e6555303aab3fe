// One message for the user (see complain.h).
//
// Flow: scene -> buffers -> kernel -> image -> comparison. Read next: clean_text.c.
#include "complain.h"

#include "clean_text.h"

#include <stdarg.h>
#include <stdio.h>

enum { LONGEST_MESSAGE = 8000 };  // two paths of the longest kind, nearly

void complain(const char *format, ...)
{
    char text[LONGEST_MESSAGE + 1];
    char clean[CLEAN_TEXT_GROWTH * LONGEST_MESSAGE + 1];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    text_show(text, 1, clean);
    fprintf(stderr, "%s\n", clean);
}
