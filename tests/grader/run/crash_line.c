// Reading the address sanitizer's report strictly (see crash_line.h).
#include "crash_line.h"

#include "folder.h"
#include "holes.h"
#include "message.h"
#include "path.h"
#include "text_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { REPORT_BYTES = 1 << 17, FRAME_BYTES = 768, MAX_LINE = 1000000 };

// What the sanitizer calls a fault, the first that fits, and what we call it.
static const char *const faults[][2] = {
    {"-buffer-overflow", "an index or a pointer beyond the end of its array"},
    {"-buffer-underflow", "an index or a pointer before the beginning of its array"},
    {"heap-use-after-free", "memory is used that was freed before"},
    {"stack-use-after-", "a local variable is used after its end"},
    {"attempting double-free", "memory is freed twice"},
    {"attempting free on address", "memory is freed that malloc() did not give"},
    {"stack-overflow", "the stack is full: a recursion without an end, or a very large array?"},
    {"-size-too-big", "more memory is asked for than there can be"},
    {"calloc-overflow", "more memory is asked for than there can be"},
    {"negative-size-param", "a size below zero"},
    {"-param-overlap", "memory is copied onto itself"},
    {"points to the zero page", "a null pointer"},
    {"SEGV on unknown address", "an index or a pointer far out of range"},
    {"FPE on unknown address", "a division by zero"},
    {"ABRT on unknown address", "the program ended itself: abort() or assert()?"},
};

static const char *fault_find(const char *report)
{
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        if (strstr(report, faults[i][0]) != NULL) {
            return faults[i][1];
        }
    }
    return "it crashed here";
}

// The number of a line behind "labs/NN-name/FILE:" in one frame of the stack, or 0.
static int frame_line(const char *frame, const Manifest *manifest, const char *name)
{
    char place[PATH_MAX];
    path_make(place, "labs/%s/%s:", manifest->lab, name);
    const char *at = strstr(frame, place);
    if (at == NULL || (at[-1] != '/' && at[-1] != ' ')) {
        return 0;
    }
    at += strlen(place);
    const size_t n_digits = strspn(at, "0123456789");
    return n_digits > 0 && n_digits < sizeof "999999" ? (int)strtol(at, NULL, 10) : 0;
}

int crash_line_read(const char *report, const Manifest *manifest, const char **file,
                    const char **says)
{
    *says = fault_find(report);
    int number = 0;  // of the frame that is looked for: each stack begins with #0
    for (const char *at = report; at != NULL; at = strchr(at, '\n')) {
        char frame[FRAME_BYTES], expected[16];
        at += *at == '\n';
        snprintf(frame, sizeof frame, "%.*s", (int)strcspn(at, "\n"), at);
        const char *begin = frame + strspn(frame, " ");
        snprintf(expected, sizeof expected, "#%d ", number);
        if (strncmp(begin, "#0 ", 3) == 0 && number > 0) {
            return 0;
        }
        if (strncmp(begin, expected, strlen(expected)) != 0) {
            continue;
        }
        number++;
        for (int i = 0; i < manifest->n_files; i++) {
            const int line = frame_line(begin, manifest, manifest->files[i]);
            if (line > 0) {
                *file = manifest->files[i];
                return line;
            }
        }
    }
    return 0;
}

char *report_load(const char *path)
{
    size_t n_bytes;
    const int file = folder_file_open(AT_FDCWD, path, &n_bytes);
    char *text = file >= 0 ? calloc(1, REPORT_BYTES) : NULL;
    if (text != NULL && read(file, text, REPORT_BYTES - 1) <= 0) {
        free(text);
        text = NULL;
    }
    if (file >= 0) {
        close(file);
    }
    return text;
}

char *report_find(const char *out, const char *prefix)
{
    struct dirent **entries;
    char *text = NULL;
    const int n = scandir(out, &entries, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        if (text == NULL && strncmp(entries[i]->d_name, prefix, strlen(prefix)) == 0) {
            char path[PATH_MAX];
            path_make(path, "%s/%s", out, entries[i]->d_name);
            text = report_load(path);
        }
        free(entries[i]);
    }
    if (n >= 0) {
        free(entries);
    }
    return text;
}

const char *task_of_line(const Manifest *manifest, const char *file, const char *text, int line)
{
    for (int i = 0; i < manifest->n_tasks; i++) {
        const Task *task = &manifest->tasks[i];
        if (strcmp(task->file, file) == 0 && hole_has_line(text, task->id, line)) {
            return task->id;
        }
    }
    return NULL;
}

char *crash_line_find(const char *out, const char *lab, const Manifest *manifest, const char **task)
{
    const char *file, *says;
    *task = NULL;
    char *report = report_find(out, "crash.");
    const int line = report != NULL ? crash_line_read(report, manifest, &file, &says) : 0;
    free(report);
    if (line == 0) {
        return NULL;
    }
    char path[PATH_MAX];
    path_make(path, "%s/%s", lab, file);
    char *text = text_file_read(path);
    size_t length;
    const char *source = text != NULL ? text_line(text, line, &length) : NULL;
    char *message = NULL;
    if (source != NULL) {
        *task = task_of_line(manifest, file, text, line);
        message = message_new("%s:%d%s%s: %s\n    %.*s\n", file, line, *task ? ", task " : "",
                              *task ? *task : "", says, (int)length, source);
    }
    free(text);
    return message;
}
