// Macros of the student's own, which may be the reason that an answer is right only together with
// the others, or only alone (see grading.h).
#include "grading.h"

#include "message.h"
#include "skeleton.h"
#include "source_words.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// The names of macros, as they were found or sorted.
typedef struct Macros {
    char **names;
    size_t n;
} Macros;

static void name_add(Macros *macros, const char *name)
{
    macros->names = realloc(macros->names, (macros->n + 1) * sizeof *macros->names);
    if (macros->names == NULL) {
        abort();
    }
    macros->names[macros->n++] = message_new("%s", name);
}

// Add those that a source defines. Takes the source over; NULL has none.
static void macros_add(Macros *macros, char *source)
{
    SourceReader reader = source_reader(source != NULL ? source : "");
    for (SourceWord word = source_next_macro(&reader); word.kind != SOURCE_END;
         word = source_next_macro(&reader)) {
        name_add(macros, word.text);
    }
    free(source);
}

static int name_compare(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void macros_sort(Macros *macros)
{
    qsort(macros->names, macros->n, sizeof *macros->names, name_compare);
}

// Is it among them? They are sorted.
static int macros_have(const Macros *macros, const char *name)
{
    return macros->n > 0 &&
           bsearch(&name, macros->names, macros->n, sizeof *macros->names, name_compare) != NULL;
}

static void macros_free(Macros *macros)
{
    for (size_t i = 0; i < macros->n; i++) {
        free(macros->names[i]);
    }
    free(macros->names);
}

// Those of the files as they are handed out, and those of the student's own files.
static void files_read(const Grading *grading, Macros *given, Macros *own)
{
    const Manifest *manifest = &grading->session.manifest;
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        grading_own_path(grading, manifest->files[i], path);
        macros_add(given, skeleton_read(manifest, manifest->files[i]));
        macros_add(own, text_file_read(path));
    }
}

char *grading_own_macros(const Grading *grading)
{
    enum { MOST_LISTED = 8 };
    Macros known = {0}, own = {0};
    char *list = message_new("%s", "");
    files_read(grading, &known, &own);
    macros_sort(&known);
    int n_listed = 0;
    for (size_t i = 0; i < own.n && n_listed < MOST_LISTED; i++) {
        if (!macros_have(&known, own.names[i])) {
            char *longer = message_new("%s%s%s", list, n_listed > 0 ? ", " : "", own.names[i]);
            free(list);
            list = longer;
            name_add(&known, own.names[i]);
            macros_sort(&known);
            n_listed++;
        }
    }
    macros_free(&known);
    macros_free(&own);
    return list;
}

char *grading_lacked_macro(const Grading *grading, int t)
{
    char *answer = grading_answer(grading, &grading->session.manifest.tasks[t]), *lacked = NULL;
    Macros had = {0}, own = {0};
    if (answer == NULL) {
        return NULL;
    }
    files_read(grading, &had, &own);
    macros_add(&had, message_new("%s", answer));
    macros_sort(&had);
    macros_sort(&own);
    SourceReader reader = source_reader(answer);
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END && lacked == NULL;
         word = source_next(&reader)) {
        if (word.kind == SOURCE_NAME && macros_have(&own, word.text) &&
            !macros_have(&had, word.text)) {
            lacked = message_new("%s", word.text);
        }
    }
    macros_free(&had);
    macros_free(&own);
    free(answer);
    return lacked;
}
