// Messages on the heap.
#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

char *message_new(const char *format, ...)
{
    char *text = NULL;
    va_list arguments;
    va_start(arguments, format);
    const int length = vasprintf(&text, format, arguments);
    va_end(arguments);
    if (length < 0) {
        fprintf(stderr, "grade: no memory for a message\n");
        exit(2);
    }
    return text;
}
