// A file that appears whole or not at all (see output_file.h).
//
// Renaming within a folder is atomic in POSIX; that is the whole trick. Read next: stats.c, a short
// user of it.
//
// A stream of stdio knows that a write failed and not why, and a library's own stream may not even
// tell that. So every byte goes through descriptor_write(), which keeps the reason.
#include "output_file.h"

#include "complain.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// A name of its own in the file's folder: the file's with something added could be longer than a
// name may be. mkstemp() fills in the six X. A leading dot would hide what a killed program left.
#define PARTIAL_NAME "partial-XXXXXX"

static int report(const char *path, const char *fault)
{
    complain("%s: cannot be written: %s", path, fault);
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

// What the stream calls to write. Returns n_bytes, or 0 after a fault.
static ssize_t descriptor_write(void *cookie, const char *bytes, size_t n_bytes)
{
    OutputFile *output = cookie;
    for (size_t n_written = 0; n_written < n_bytes;) {
        const ssize_t n = write(output->descriptor, bytes + n_written, n_bytes - n_written);
        if (n >= 0) {
            n_written += (size_t)n;
        } else if (errno != EINTR) {
            output->fault = errno;
            return 0;
        }
    }
    return (ssize_t)n_bytes;
}

// Where a file is written before it has its name, for mkstemp(). NULL when memory runs out.
static char *partial_path_create(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t folder_length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    char *partial_path = malloc(folder_length + sizeof PARTIAL_NAME);
    if (partial_path != NULL) {
        memcpy(partial_path, path, folder_length);
        strcpy(partial_path + folder_length, PARTIAL_NAME);
    }
    return partial_path;
}

int output_file_open(OutputFile *output, const char *path)
{
    *output = (OutputFile){.descriptor = -1};
    if (!is_replaceable(path)) {
        return report(path, "not a regular file");
    }

    output->path = strdup(path);
    output->partial_path = partial_path_create(path);
    if (output->path == NULL || output->partial_path == NULL) {
        free(output->partial_path);
        free(output->path);
        *output = (OutputFile){0};
        return report(path, "no memory");
    }

    const cookie_io_functions_t functions = {.write = descriptor_write};
    output->descriptor = mkstemp(output->partial_path);
    if (output->descriptor >= 0 && rights_set(output->descriptor) == 0) {
        output->file = fopencookie(output, "wb", functions);
    }
    if (output->file == NULL) {
        const int fault = errno;
        output_file_discard(output);
        return report(path, strerror(fault));
    }
    return 0;
}

int output_file_store(OutputFile *output)
{
    if ((fflush(output->file) != 0 || ferror(output->file)) && output->fault == 0) {
        output->fault = EIO;
    }
    // Only this shows what a disk, or one at the other end of a network, has no room for. Some file
    // systems do not know it (EINVAL).
    if (output->fault == 0 && fsync(output->descriptor) != 0 && errno != EINVAL) {
        output->fault = errno;
    }
    return output->fault == 0 ? 0 : report(output->path, strerror(output->fault));
}

int output_file_commit(OutputFile *output)
{
    int result = output_file_store(output);
    if (result == 0) {
        result = close(output->descriptor);
        output->descriptor = -1;
        if (result != 0 || rename(output->partial_path, output->path) != 0) {
            result = report(output->path, strerror(errno));
        }
    }
    if (result == 0) {
        // It has another name now: nothing is left to be removed.
        free(output->partial_path);
        output->partial_path = NULL;
    }
    output_file_discard(output);
    return result;
}

void output_file_discard(OutputFile *output)
{
    if (output->file != NULL) {
        fclose(output->file);
    }
    if (output->path != NULL && output->descriptor >= 0) {
        close(output->descriptor);
    }
    if (output->partial_path != NULL) {
        unlink(output->partial_path);
    }
    free(output->partial_path);
    free(output->path);
    *output = (OutputFile){.descriptor = -1};
}
