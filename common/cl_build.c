// Programs from .cl files (cl_setup_build() of cl_setup.h).
//
// The driver gets the text of a program and not its file, so the text begins with a #line that says
// where it is from, and an -I that says where its headers are. Read next: build_log.c.
#include "build_log.h"
#include "cl_setup.h"
#include "complain.h"
#include "text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// What a driver may take for the end of an option, or for something else. PoCL 3.1 knows no way to
// write a space in a path, quoted or not.
#define UNSAFE_IN_OPTIONS " \t\n\"'#\\"

// The folder of a program, under a name that can stand in the build options.
typedef struct ProgramFolder {
    char *path;             // as its author knows it
    int descriptor;         // open where the path is unsafe, else -1
    char open_as[32];       // "/proc/self/fd/7": the same folder, by its descriptor
    const char *in_option;  // path or open_as
} ProgramFolder;

static int report(const char *path, const char *fault)
{
    complain("%s: %s", path, fault);
    return -1;
}

static char *folder_of_file(const char *path)
{
    const char *slash = strrchr(path, '/');
    if (slash == NULL) {
        return strdup(".");
    }
    return slash == path ? strdup("/") : strndup(path, (size_t)(slash - path));
}

static void folder_close(ProgramFolder *folder)
{
    if (folder->descriptor >= 0) {
        close(folder->descriptor);
    }
    free(folder->path);
}

// Find the folder of a program. Returns 0, or -1 after one message.
static int folder_open(const char *program_path, ProgramFolder *folder)
{
    *folder = (ProgramFolder){.path = folder_of_file(program_path), .descriptor = -1};
    if (folder->path == NULL) {
        return report(program_path, "no memory");
    }
    folder->in_option = folder->path;
    if (strpbrk(folder->path, UNSAFE_IN_OPTIONS) == NULL) {
        return 0;
    }

    // The system has another name for every open folder, one without spaces.
    folder->descriptor = open(folder->path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder->descriptor < 0) {
        int fault = errno;
        folder_close(folder);
        complain("%s: cannot be read: %s", program_path, strerror(fault));
        return -1;
    }
    snprintf(folder->open_as, sizeof folder->open_as, "/proc/self/fd/%d", folder->descriptor);
    folder->in_option = folder->open_as;
    if (access(folder->open_as, X_OK) == 0) {
        return 0;
    }
    folder_close(folder);
    return report(program_path, "a folder with spaces or quotes in its name cannot be searched for "
                                "headers on this system; rename it");
}

// A path as a string of OpenCL C.
static void path_write_quoted(FILE *out, const char *path)
{
    fputc('"', out);
    for (; *path != '\0'; path++) {
        if (*path == '"' || *path == '\\') {
            fputc('\\', out);
        }
        fputc(*path, out);
    }
    fputc('"', out);
}

// Read a program and write where it is from before it. Returns its text, to be freed, or NULL after
// one message.
static char *source_read(const char *path)
{
    char *program = text_file_read(path);
    if (program == NULL) {
        return NULL;
    }
    char *source = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&source, &length);
    int failed = text == NULL;
    if (text != NULL) {
        fprintf(text, "#line 1 ");
        path_write_quoted(text, path);
        fprintf(text, "\n%s\n", program);
        failed = fclose(text) != 0;
    }
    free(program);
    if (failed) {
        free(source);
        report(path, "no memory");
        return NULL;
    }
    return source;
}

// Returns the build options, to be freed, or NULL when memory ran out.
static char *options_join(const ProgramFolder *folder, const char *options)
{
    char *joined = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&joined, &length);
    if (text == NULL) {
        return NULL;
    }
    fprintf(text, "-cl-std=CL1.2 -I%s", folder->in_option);
    if (options != NULL && options[0] != '\0') {
        fprintf(text, " %s", options);
    }
    if (fclose(text) != 0) {
        free(joined);
        return NULL;
    }
    return joined;
}

// Returns the driver's log, to be freed; "" when it has none.
static char *log_read(const ClSetup *setup, cl_program program)
{
    size_t n_bytes = 0;
    clGetProgramBuildInfo(program, setup->device, CL_PROGRAM_BUILD_LOG, 0, NULL, &n_bytes);
    char *log = calloc(n_bytes + 1, 1);
    if (log != NULL && n_bytes > 0) {
        clGetProgramBuildInfo(program, setup->device, CL_PROGRAM_BUILD_LOG, n_bytes, log, NULL);
    }
    return log;
}

// PoCL without a place for its cache fails with no reason given.
static void silent_failure_report(const char *path, cl_int error)
{
    const char *cache = getenv("POCL_CACHE_DIR");
    complain("%s: the build failed with %s and no message; can PoCL write to its cache folder, %s? "
             "(POCL_CACHE_DIR names another)",
             path, cl_error_name(error), cache != NULL ? cache : "~/.cache/pocl");
}

// Build and print the log. Returns the program, or NULL after the messages.
static cl_program program_build(const ClSetup *setup, const char *path, const char *source,
                                const ProgramFolder *folder, const char *options)
{
    cl_int error = CL_SUCCESS;
    cl_program program = clCreateProgramWithSource(setup->context, 1, &source, NULL, &error);
    if (program == NULL) {
        silent_failure_report(path, error);
        return NULL;
    }
    error = clBuildProgram(program, 1, &setup->device, options, NULL, NULL);

    // A build that succeeds may have warnings to show.
    char *log = log_read(setup, program);
    int n_messages = 0;
    if (log != NULL) {
        n_messages = build_log_print(stderr, log, path, folder->open_as, folder->path);
    }
    free(log);
    if (error == CL_SUCCESS) {
        return program;
    }
    if (n_messages == 0) {
        silent_failure_report(path, error);
    }
    clReleaseProgram(program);
    return NULL;
}

cl_program cl_setup_build(const ClSetup *setup, const char *path, const char *options)
{
    ProgramFolder folder;
    if (folder_open(path, &folder) != 0) {
        return NULL;
    }
    char *source = source_read(path);
    char *all_options = options_join(&folder, options);
    cl_program program = NULL;
    if (source != NULL && all_options == NULL) {
        report(path, "no memory");
    } else if (source != NULL) {
        program = program_build(setup, path, source, &folder, all_options);
    }
    free(all_options);
    free(source);
    folder_close(&folder);
    return program;
}
