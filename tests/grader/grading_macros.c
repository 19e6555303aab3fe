// Macros of the student's own, which may be the reason that an answer is right only together with
// the others, or only alone (see grading.h).
#include "grading.h"

#include "message.h"
#include "skeleton.h"
#include "source_words.h"
#include "text_file.h"

#include <search.h>
#include <stdlib.h>
#include <string.h>

// ---- Sets of names, each a tree of tsearch()'s --------------------------------------------------

static int name_compare(const void *a, const void *b)
{
    return strcmp(a, b);
}

static void name_add(void **names, const char *name)
{
    char *copy = message_new("%s", name);
    char **node = tsearch(copy, names, name_compare);
    if (node == NULL) {
        abort();  // no memory
    }
    if (*node != copy) {
        free(copy);
    }
}

static int names_have(void *const *names, const char *name)
{
    return tfind(name, names, name_compare) != NULL;
}

// Add the macros that a source defines. Takes the source over; NULL has none.
static void macros_add(void **names, char *source)
{
    SourceReader reader = source_reader(source != NULL ? source : "");
    for (SourceWord word = source_next_macro(&reader); word.kind != SOURCE_END;
         word = source_next_macro(&reader)) {
        name_add(names, word.text);
    }
    free(source);
}

// ---- Macros of the student's own ----------------------------------------------------------------

// Add the macros of the files as they are handed out.
static void given_add(void **names, const Manifest *manifest)
{
    for (int i = 0; i < manifest->n_files; i++) {
        macros_add(names, skeleton_read(manifest, manifest->files[i]));
    }
}

static char *own_read(const Grading *grading, int i)
{
    char path[PATH_MAX];
    grading_own_path(grading, grading->session.manifest.files[i], path);
    return text_file_read(path);
}

char *grading_own_macros(const Grading *grading)
{
    enum { MOST_LISTED = 8 };
    const Manifest *manifest = &grading->session.manifest;
    void *known = NULL;
    int n_listed = 0;
    char *list = message_new("%s", "");
    given_add(&known, manifest);
    for (int i = 0; i < manifest->n_files; i++) {
        char *source = own_read(grading, i);
        SourceReader reader = source_reader(source != NULL ? source : "");
        for (SourceWord word = source_next_macro(&reader);
             word.kind != SOURCE_END && n_listed < MOST_LISTED; word = source_next_macro(&reader)) {
            if (!names_have(&known, word.text)) {
                char *longer = message_new("%s%s%s", list, n_listed++ > 0 ? ", " : "", word.text);
                free(list);
                list = longer;
                name_add(&known, word.text);
            }
        }
        free(source);
    }
    tdestroy(known, free);
    return list;
}

char *grading_lacked_macro(const Grading *grading, int t)
{
    const Manifest *manifest = &grading->session.manifest;
    char *answer = grading_answer(grading, &manifest->tasks[t]), *lacked = NULL;
    void *had = NULL, *own = NULL;
    if (answer == NULL) {
        return NULL;
    }
    given_add(&had, manifest);
    macros_add(&had, message_new("%s", answer));
    for (int i = 0; i < manifest->n_files; i++) {
        macros_add(&own, own_read(grading, i));
    }
    SourceReader reader = source_reader(answer);
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END && lacked == NULL;
         word = source_next(&reader)) {
        if (word.kind == SOURCE_NAME && names_have(&own, word.text) &&
            !names_have(&had, word.text)) {
            lacked = message_new("%s", word.text);
        }
    }
    tdestroy(had, free);
    tdestroy(own, free);
    free(answer);
    return lacked;
}
