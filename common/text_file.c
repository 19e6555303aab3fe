// Reading text files: scenes, kernels, manifests, solutions (see text_file.h). All are small.
//
// A program's text on its way to the driver. Read next: cl_build.c.
#include "text_file.h"

#include "complain.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void *report(const char *path, const char *fault)
{
    complain("%s: cannot be read: %s", path, fault);
    return NULL;
}

FILE *text_file_open(const char *path)
{
    // Without O_NONBLOCK, opening a pipe waits for its writer; a regular file does not heed it.
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    struct stat status;
    FILE *file = NULL;
    if (descriptor < 0 || fstat(descriptor, &status) != 0) {
        report(path, strerror(errno));
    } else if (S_ISDIR(status.st_mode)) {
        report(path, "found a folder, expected a file");
    } else if (!S_ISREG(status.st_mode)) {
        report(path, "found a pipe or a device, expected a regular file");
    } else if ((file = fdopen(descriptor, "rb")) == NULL) {
        report(path, strerror(errno));
    }
    if (file == NULL && descriptor >= 0) {
        close(descriptor);
    }
    return file;
}

char *text_file_read(const char *path)
{
    FILE *file = text_file_open(path);
    if (file == NULL) {
        return NULL;
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

const char *text_line(const char *text, int number, size_t *length)
{
    for (int i = 1; i < number && text != NULL; i++) {
        text = strchr(text, '\n');
        text += text != NULL;
    }
    *length = text != NULL ? strcspn(text, "\n") : 0;
    return text != NULL && text[0] != '\0' ? text : NULL;
}
