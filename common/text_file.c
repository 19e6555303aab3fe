// Reading a text file whole: kernels, manifests, solutions. All are small.
#include "text_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *text_file_read(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
        return NULL;
    }
    char *text = NULL;
    size_t capacity = 0;
    // A file without NUL bytes is one long "line" up to the delimiter NUL.
    const ssize_t length = getdelim(&text, &capacity, '\0', file);
    const int failed = ferror(file);
    const int reason = errno;
    fclose(file);
    if (failed) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(reason));
        free(text);
        return NULL;
    }
    return length >= 0 ? text : (free(text), calloc(1, 1));
}
