// Looking at what was saved (see saved.h).
#include "saved.h"

#include "path.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

// FNV-1a, in 64 bits: http://www.isthe.com/chongo/tech/comp/fnv/
#define FNV_START 14695981039346656037U
#define FNV_PRIME 1099511628211U

static uint64_t sum_bytes(uint64_t sum, const unsigned char *bytes, size_t n_bytes)
{
    for (size_t i = 0; i < n_bytes; i++) {
        sum = (sum ^ bytes[i]) * FNV_PRIME;
    }
    return sum;
}

static uint64_t sum_file(const char *path)
{
    unsigned char bytes[16384];
    uint64_t sum = FNV_START;
    size_t n;
    FILE *file = fopen(path, "rb");
    while (file != NULL && (n = fread(bytes, 1, sizeof bytes, file)) > 0) {
        sum = sum_bytes(sum, bytes, n);
    }
    if (file != NULL) {
        fclose(file);
    }
    return sum;
}

void saved_look(const char *folder, SavedFiles *files)
{
    char pattern[PATH_MAX];
    glob_t found;
    *files = (SavedFiles){.sum = FNV_START};
    path_make(pattern, "%s/*.{c,h,cl}", folder);
    if (glob(pattern, GLOB_BRACE, NULL, &found) != 0) {
        return;
    }
    for (size_t i = 0; i < found.gl_pathc && files->n_files < SAVED_MAX_FILES; i++) {
        const int f = files->n_files++;
        snprintf(files->names[f], sizeof files->names[f], "%s",
                 strrchr(found.gl_pathv[i], '/') + 1);
        files->sums[f] = sum_file(found.gl_pathv[i]);
        files->sum =
            sum_bytes(files->sum, (const unsigned char *)files->names[f], strlen(files->names[f]));
        files->sum =
            sum_bytes(files->sum, (const unsigned char *)&files->sums[f], sizeof files->sums[f]);
    }
    globfree(&found);
}

static const uint64_t *sum_of(const SavedFiles *files, const char *name)
{
    for (int i = 0; i < files->n_files; i++) {
        if (strcmp(files->names[i], name) == 0) {
            return &files->sums[i];
        }
    }
    return NULL;
}

// Add the names of `files` that `others` has not, or, with `changed`, has otherwise.
static int add_names(const SavedFiles *files, const SavedFiles *others, int changed, char *line,
                     int n_bytes, int length)
{
    for (int i = 0; i < files->n_files && length < n_bytes; i++) {
        const uint64_t *other = sum_of(others, files->names[i]);
        if (other == NULL || (changed && *other != files->sums[i])) {
            length += snprintf(line + length, (size_t)(n_bytes - length), "%s%s%s",
                               length > 0 ? ", " : "", files->names[i], changed ? "" : " (gone)");
        }
    }
    return length;
}

char *saved_changes(const SavedFiles *before, const SavedFiles *now, char *line, int n_bytes)
{
    line[0] = '\0';
    const int length = add_names(now, before, 1, line, n_bytes, 0);
    add_names(before, now, 0, line, n_bytes, length);
    return line;
}

void saved_to_make(const SavedFiles *before, const SavedFiles *now,
                   const char *names[SAVED_MAX_FILES + 1])
{
    int n = 0;
    for (int i = 0; i < now->n_files; i++) {
        const char *name = now->names[i], *ending = strrchr(name, '.');
        const uint64_t *old = sum_of(before, name);
        const int is_changed = old == NULL || *old != now->sums[i];
        const int is_relinked = strcmp(name, "main.c") == 0 && before->n_files != now->n_files;
        if (strcmp(ending, ".cl") != 0 && (is_changed || is_relinked)) {
            names[n++] = name;
        }
    }
    names[n] = NULL;
}
