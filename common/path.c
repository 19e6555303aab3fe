// Making paths (see path.h).
#include "path.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void path_make(char path[PATH_MAX], const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(path, PATH_MAX, format, arguments);
    va_end(arguments);
    if (length < 0 || length >= PATH_MAX) {
        memset(path + PATH_MAX - 1 - (NAME_MAX + 1), 'x', NAME_MAX + 1);
    }
}
