// A file that appears whole or not at all (see output_file.h).
//
// Flow: scene -> buffers -> kernel -> IMAGE -> comparison. Renaming within a folder is atomic in
// POSIX; that is the whole trick. Read next: stats.c, a short user of it.
#include "output_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// The six X are filled in by mkstemp(). A leading dot would hide what a killed program left behind.
#define PARTIAL_SUFFIX ".partial-XXXXXX"

static int report(const char *path, const char *fault)
{
    fprintf(stderr, "%s: cannot be written: %s\n", path, fault);
    return -1;
}

static int is_replaceable(const char *path)
{
    struct stat status;
    return stat(path, &status) != 0 || S_ISREG(status.st_mode);
}

// mkstemp() lets only the owner read; a picture should have the rights of any newly made file.
static int rights_set(int descriptor)
{
    mode_t mask = umask(0);
    umask(mask);
    return fchmod(descriptor, 0666 & ~mask);
}

int output_file_open(OutputFile *output, const char *path)
{
    *output = (OutputFile){0};
    if (!is_replaceable(path)) {
        return report(path, "not a regular file");
    }

    size_t n_bytes = strlen(path) + sizeof PARTIAL_SUFFIX;
    output->path = strdup(path);
    output->partial_path = malloc(n_bytes);
    if (output->path == NULL || output->partial_path == NULL) {
        free(output->partial_path);
        free(output->path);
        *output = (OutputFile){0};
        return report(path, "no memory");
    }
    snprintf(output->partial_path, n_bytes, "%s%s", path, PARTIAL_SUFFIX);

    int descriptor = mkstemp(output->partial_path);
    if (descriptor >= 0 && rights_set(descriptor) == 0) {
        output->file = fdopen(descriptor, "wb");
    }
    if (output->file == NULL) {
        int fault = errno;
        if (descriptor >= 0) {
            close(descriptor);
        }
        output_file_discard(output);
        return report(path, strerror(fault));
    }
    return 0;
}

int output_file_commit(OutputFile *output)
{
    // An error may have struck at any earlier fprintf(); the stream remembers it, errno does not.
    int failed = ferror(output->file);
    int fault = EIO;
    if (fclose(output->file) != 0) {
        failed = 1;
        fault = errno;
    }
    output->file = NULL;
    if (!failed && rename(output->partial_path, output->path) != 0) {
        failed = 1;
        fault = errno;
    }
    if (failed) {
        report(output->path, strerror(fault));
        output_file_discard(output);
        return -1;
    }
    free(output->partial_path);
    free(output->path);
    *output = (OutputFile){0};
    return 0;
}

void output_file_discard(OutputFile *output)
{
    if (output->file != NULL) {
        fclose(output->file);
    }
    if (output->partial_path != NULL) {
        unlink(output->partial_path);
    }
    free(output->partial_path);
    free(output->path);
    *output = (OutputFile){0};
}
