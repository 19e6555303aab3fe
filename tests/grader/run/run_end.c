// Ends of runs in words (see run_end.h).
#include "run_end.h"

#include "cl_check.h"
#include "message.h"
#include "probe.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The numbers of OpenCL's errors, those of its extensions included, end before this.
enum { LAST_OPENCL_ERROR = -1200 };

// The OpenCL error that a failed CL_CHECK named in a program's output, or NULL. The name is taken
// from the table and not from the output: nothing else that a program prints is passed on here.
static const char *opencl_error_find(const char *output)
{
    const char *place = strstr(output, ": CL_");
    if (place == NULL) {
        return NULL;
    }
    place += strlen(": ");
    const size_t length = strspn(place, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
    for (cl_int error = -1; error >= LAST_OPENCL_ERROR; error--) {
        const char *name = cl_error_name(error);
        if (strlen(name) == length && strncmp(name, place, length) == 0) {
            return name;
        }
    }
    return NULL;
}

static char *describe_limit(SandboxLimit limit)
{
    switch (limit) {
    case SANDBOX_LIMIT_PROCESSES:
        return message_new("it was stopped: it started more than %d processes and threads",
                           N_PROCESSES);
    case SANDBOX_LIMIT_MEMORY:
        return message_new("it was stopped: it used more than %d GB of memory in all",
                           TOTAL_MEMORY_MB / 1024);
    case SANDBOX_LIMIT_MAPPINGS:
        return message_new("it was stopped: its processes had more than %d mappings of memory in "
                           "all; mmap() in a loop, or a process that has many and forks?",
                           SANDBOX_MAX_MAPPINGS);
    case SANDBOX_LIMIT_OPEN_FILES:
        return message_new("it was stopped: its processes had more than %d files open in all",
                           SANDBOX_MAX_OPEN_FILES);
    case SANDBOX_LIMIT_BYTES:
        return message_new("it was stopped: it wrote more than %d MB in all", TOTAL_FILE_MB);
    case SANDBOX_LIMIT_FILES:
        return message_new("it was stopped: it made more than %d files, or folders too deep to "
                           "look into",
                           N_FILES);
    case SANDBOX_LIMIT_NONE:
        break;
    }
    return NULL;
}

int run_end_is_as_compilers(const SandboxResult *result)
{
    return (result->outcome == SANDBOX_EXITED && result->exit_status == EXIT_FAILURE) ||
           (result->outcome == SANDBOX_CRASHED && result->signal == SIGABRT);
}

// What may have led to a signal.
static const char *suspect(const SandboxResult *result)
{
    return result->signal == SIGSEGV || result->signal == SIGABRT
               ? "; an index or a pointer out of range?"
               : "";
}

char *run_end_describe(const SandboxResult *result, SandboxTime allowed)
{
    switch (result->outcome) {
    case SANDBOX_TIMED_OUT:
        return message_new("it did not finish in time: it used up the %.1f s of processor time "
                           "that are allowed; an endless loop?",
                           allowed.processor);
    case SANDBOX_ASLEEP:
        return message_new("it did not finish in time: it waited, without using a processor, for "
                           "the %.1f s that are allowed; a sleep, or a wait for what never comes?",
                           allowed.asleep);
    case SANDBOX_OVERDUE:
        return message_new("it did not finish in time: after %.0f s it had neither used up its "
                           "processor time nor waited for a processor; does it wait for a disk, or "
                           "for processes that it started?",
                           allowed.wall);
    case SANDBOX_CRASHED:
        if (result->signal == SIGXFSZ) {
            return message_new("it was stopped: it wrote a file of more than %d MB", FILE_MB);
        }
        return message_new("it crashed: signal %d (%s)%s", result->signal,
                           strsignal(result->signal), suspect(result));
    case SANDBOX_FORBIDDEN:
        return message_new("it was stopped: it asked the system for something no answer needs, "
                           "such as a network connection");
    case SANDBOX_EXCEEDED:
        return describe_limit(result->limit);
    case SANDBOX_EXITED:
        break;
    case SANDBOX_STARVED:
    case SANDBOX_FAULT:
        return NULL;
    }
    if (result->exit_status == 0) {
        return NULL;
    }
    const char *error = opencl_error_find(result->output);
    return message_new("it ended early with exit status %d%s%s%s", result->exit_status,
                       error ? " (" : "", error ? error : "", error ? ")" : "");
}

char *run_end_of_probe(const SandboxResult *result, SandboxTime allowed, const Sections *answers)
{
    size_t n_bytes;
    char *end = run_end_describe(result, allowed);
    if (end == NULL && sections_find_any(answers, PROBE_END, &n_bytes) == NULL) {
        end = message_new("it ended by itself, with exit status 0, before it had answered "
                          "everything: a call of exit()?");
    }
    return end;
}

char *run_habits_describe(const SandboxResult *result, int is_second)
{
    char *habits = NULL;
    size_t length = 0;
    FILE *text = open_memstream(&habits, &length);
    if (text == NULL) {
        return message_new("%s", "");
    }
    if (is_second) {
        fprintf(text, "it ended early, and came to its end in a second try with " SECOND_COMPILER
                      ", another way of PoCL's to compile kernels: try it at home, too\n");
    }
    if (result->n_printed > SANDBOX_MAX_OUTPUT) {
        const double megabytes = (double)result->n_printed / 1e6;
        fprintf(text, "it printed %.1f %s; only the first %d KB are kept\n",
                megabytes < 1000 ? megabytes : megabytes / 1000, megabytes < 1000 ? "MB" : "GB",
                SANDBOX_MAX_OUTPUT / 1024);
    }
    if (result->n_left > 0) {
        fprintf(text, "it left %d process%s running; %s ended\n", result->n_left,
                result->n_left == 1 ? "" : "es", result->n_left == 1 ? "it was" : "they were");
    }
    fclose(text);
    if (length > 0) {
        habits[length - 1] = '\0';
    }
    return habits;
}
