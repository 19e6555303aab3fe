// Reading a text file whole: kernels, manifests, solutions (see text_file.h). All are small.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison: a program's text on its way to the
// driver. Read next: cl_build.c.
#include "text_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *report(const char *path, const char *fault)
{
    fprintf(stderr, "%s: cannot be read: %s\n", path, fault);
    return NULL;
}

char *text_file_read(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return report(path, strerror(errno));
    }
    char *text = NULL;
    size_t capacity = 0;
    // A file without NUL bytes is one long "line" up to the delimiter NUL.
    const ssize_t length = getdelim(&text, &capacity, '\0', file);
    const int reason = errno;
    const int failed = ferror(file) || (length < 0 && !feof(file));
    fclose(file);

    const char *fault = NULL;
    if (failed) {
        fault = strerror(reason);
    } else if (length > 0 && text[length - 1] == '\0') {
        fault = "found a NUL byte, expected text";
    } else if (length < 0) {
        // An empty file is no line at all.
        free(text);
        text = strdup("");
        fault = text == NULL ? "no memory" : NULL;
    }
    if (fault != NULL) {
        free(text);
        return report(path, fault);
    }
    return text;
}
