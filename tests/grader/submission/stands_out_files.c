// Naming what else was handed in (see stands_out.h).
//
// The grader never uses any of it: a Makefile, a manifest or a header of the student's own has no
// effect, and this line says so. Read next: stage.c.
#include "stands_out.h"

#include "clean_text.h"
#include "contents.h"
#include "file_names.h"
#include "folder.h"
#include "path.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// How many names are shown, and how many entries are read at most.
enum { MAX_NAMES = 6, MAX_NAME_BYTES = 60, MAX_ENTRIES = 2000 };

enum { MAX_MANIFEST_BYTES = 65536 };

// A short file's bytes, not followed where it is a link. Returns their number, or -1.
static ssize_t file_bytes(int folder, const char *name, char *bytes)
{
    size_t n_bytes;
    const int descriptor = folder_file_open(folder, name, &n_bytes);
    const ssize_t n = descriptor >= 0 ? read(descriptor, bytes, MAX_MANIFEST_BYTES) : -1;
    if (descriptor >= 0) {
        close(descriptor);
    }
    return n;
}

static int is_same_file(int folder, int given_folder, const char *name)
{
    char *bytes = malloc(2 * MAX_MANIFEST_BYTES);
    if (bytes == NULL) {
        return 1;
    }
    const ssize_t n = file_bytes(folder, name, bytes);
    const ssize_t n_given = file_bytes(given_folder, name, bytes + MAX_MANIFEST_BYTES);
    const int is_same =
        n >= 0 && n == n_given && memcmp(bytes, bytes + MAX_MANIFEST_BYTES, (size_t)n) == 0;
    free(bytes);
    return is_same;
}

// Was it asked for, or does it come with the lab? A student may have changed a README or main.c
// while trying things out; a changed manifest is another matter.
static int is_expected(const Manifest *manifest, int folder, int given_folder, const char *name)
{
    if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0) {
        return 1;
    }
    for (int i = 0; i < manifest->n_files; i++) {
        if (name_match(name, manifest->files[i]) <= NAME_CHANGED) {
            return 1;
        }
    }
    // Of archives staging tells.
    if (name[0] != '.' && archive_stem_length(name) > 0) {
        return 1;
    }
    return faccessat(given_folder, name, F_OK, 0) == 0 &&
           (strcmp(name, "lab.json") != 0 || is_same_file(folder, given_folder, name));
}

static int name_compare(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

// Copy the names of unexpected entries into names[MAX_ENTRIES]. Returns how many there are; when it
// is enough, the rest is not read.
static int names_gather(const Manifest *manifest, DIR *entries, int given_folder, char **names)
{
    int n_names = 0;
    const struct dirent *entry;
    while (n_names < MAX_ENTRIES && (entry = readdir(entries)) != NULL) {
        if (!is_expected(manifest, dirfd(entries), given_folder, entry->d_name)) {
            names[n_names] = strdup(entry->d_name);
            n_names += names[n_names] != NULL;
        }
    }
    return n_names;
}

// A name in quotes, cut short. It may hold anything except for a slash: also a newline, which must
// not begin a line here.
static void name_write(FILE *notes, const char *name)
{
    char *clean = line_clean(name);
    fprintf(notes, "\"%.*s\"", MAX_NAME_BYTES, clean);
    free(clean);
}

int stands_out_in_folder(const Manifest *manifest, const char *submission, FILE *notes)
{
    char given[PATH_MAX];
    char *names[MAX_ENTRIES];
    int n_names = 0;
    path_make(given, "labs/%s", manifest->lab);
    const int given_folder = open(given, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *entries = opendir(submission);
    if (entries != NULL && given_folder >= 0) {
        n_names = names_gather(manifest, entries, given_folder, names);
    }
    if (entries != NULL) {
        closedir(entries);
    }
    if (given_folder >= 0) {
        close(given_folder);
    }
    // Folders have no order: the same submission shall give the same report.
    qsort(names, (size_t)n_names, sizeof *names, name_compare);
    for (int i = 0; i < n_names; i++) {
        if (i < MAX_NAMES) {
            fputs(i == 0 ? "handed in besides, and not looked at: " : ", ", notes);
            name_write(notes, names[i]);
        }
        free(names[i]);
    }
    if (n_names > MAX_NAMES) {
        fprintf(notes, " and %s%d more", n_names == MAX_ENTRIES ? "at least " : "",
                n_names - MAX_NAMES);
    }
    if (n_names > 0) {
        fputc('\n', notes);
    }
    return n_names > 0;
}
