// Reading skeletons and stubs (see skeleton.h).
#include "skeleton.h"

#include "holes.h"
#include "path.h"
#include "text_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

char *skeleton_read(const Manifest *manifest, const char *file)
{
    char path[PATH_MAX];
    path_make(path, "tests/skeletons/%s/%s", manifest->lab, file);
    if (access(path, F_OK) == 0) {
        return text_file_read(path);
    }
    path_make(path, "solutions/%s/%s", manifest->lab, file);
    char *solution = text_file_read(path);
    char *skeleton = solution != NULL ? holes_cut(solution, path) : NULL;
    free(solution);
    return skeleton;
}

char *placeholder_read(const Manifest *manifest, const Task *task)
{
    char *skeleton = skeleton_read(manifest, task->file);
    char *placeholder = skeleton != NULL ? hole_read(skeleton, task->id) : NULL;
    free(skeleton);
    return placeholder;
}

// The text with this number for each NONCE. Takes `text` over; NULL after one message.
static char *nonce_write(char *text, uint32_t nonce)
{
    static const char word[] = "NONCE";
    char *written = NULL;
    size_t n_bytes;
    FILE *stream = text != NULL ? open_memstream(&written, &n_bytes) : NULL;
    if (stream == NULL) {
        free(text);
        return NULL;
    }
    const char *from = text;
    for (const char *at; (at = strstr(from, word)) != NULL; from = at + strlen(word)) {
        fprintf(stream, "%.*s%" PRIu32 "u", (int)(at - from), from, nonce);
    }
    fputs(from, stream);
    free(text);
    if (fclose(stream) != 0) {
        fprintf(stderr, "grade: no memory for a stub\n");
        free(written);
        return NULL;
    }
    return written;
}

char *stub_read(const Manifest *manifest, const Task *task, uint32_t nonce)
{
    char path[PATH_MAX];
    const char *ending = strrchr(task->file, '.');
    path_make(path, "tests/stubs/%s/%s%s", manifest->lab, task->id, ending ? ending : "");
    return access(path, F_OK) == 0 ? nonce_write(text_file_read(path), nonce) : NULL;
}
