// Letting all answers run together without what stands beside them (see grading.h).
//
// Called by grading_alone.c where each answer is right alone, and the whole is not: what is left is
// a macro that reaches another task's lines, or what was changed outside of the marked ones.
#include "alone.h"
#include "grading.h"
#include "message.h"
#include "path.h"
#include "skeleton.h"
#include "source_words.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// The names of macros, each once.
enum { MAX_LISTED = 8, MAX_MACROS = 64 };
typedef struct Macros {
    char names[MAX_MACROS][SOURCE_WORD_BYTES];
    int n;
} Macros;

// Add those that a source defines, up to n_most in all. Takes the source over; NULL has none.
static void note_macros(Macros *macros, char *source, int n_most)
{
    SourceReader reader = source_reader(source != NULL ? source : "");
    SourceWord word = source_next_macro(&reader);
    for (; word.kind != SOURCE_END && macros->n < n_most; word = source_next_macro(&reader)) {
        int i = 0;
        while (i < macros->n && strcmp(macros->names[i], word.text) != 0) {
            i++;
        }
        if (i == macros->n) {
            strcpy(macros->names[macros->n++], word.text);
        }
    }
    free(source);
}

// Add those of the files as they are handed out.
static void note_given(Macros *macros, const Manifest *manifest)
{
    for (int i = 0; i < manifest->n_files; i++) {
        note_macros(macros, skeleton_read(manifest, manifest->files[i]), MAX_MACROS - MAX_LISTED);
    }
}

// Add those of the student's own files.
static void note_own(Macros *macros, const Grading *grading, int n_most)
{
    const Manifest *manifest = &grading->session.manifest;
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        path_make(path, "%s/variant-whole/lab/%s", grading->session.workshop.folder,
                  manifest->files[i]);
        note_macros(macros, text_file_read(path), n_most);
    }
}

// The macros of the student's own files that those which are handed out do not define: "r, x"; ""
// for none; of many the first. Owned by the caller.
static char *list_macros(const Grading *grading)
{
    Macros macros = {.n = 0};
    note_given(&macros, &grading->session.manifest);
    const int n_given = macros.n;
    note_own(&macros, grading, n_given + MAX_LISTED);
    char *list = message_new("%s", "");
    for (int i = n_given; i < macros.n; i++) {
        char *longer = message_new("%s%s%s", list, i > n_given ? ", " : "", macros.names[i]);
        free(list);
        list = longer;
    }
    return list;
}

char *grading_lacked_macro(const Grading *grading, int t)
{
    const Manifest *manifest = &grading->session.manifest;
    char *answer = grading_answer(grading, &manifest->tasks[t]), *lacked = NULL;
    if (answer == NULL) {
        return NULL;
    }
    Macros macros = {.n = 0};
    note_given(&macros, manifest);
    note_macros(&macros, message_new("%s", answer), MAX_MACROS - MAX_LISTED);
    const int n_had = macros.n;
    note_own(&macros, grading, MAX_MACROS);
    SourceReader reader = source_reader(answer);
    for (SourceWord word = source_next(&reader); word.kind != SOURCE_END && lacked == NULL;
         word = source_next(&reader)) {
        for (int i = n_had; i < macros.n && lacked == NULL; i++) {
            lacked = source_is(&word, SOURCE_NAME, macros.names[i])
                         ? message_new("%s", macros.names[i])
                         : NULL;
        }
    }
    free(answer);
    return lacked;
}

static void tell(Grading *grading)
{
    char *macros = list_macros(grading);
    char *message = message_new(
        "your answers pass more checks in the files as they are handed out than in yours. What is "
        "outside the marked lines, or a macro, changes what other lines do%s%s%s. They are judged "
        "without that.",
        macros[0] != '\0' ? " (macros that your files define: " : "", macros,
        macros[0] != '\0' ? "; end one with #undef, or use a variable)" : "");
    result_add_stage(&grading->result, "Beside your answers", CHECK_FAILED, message);
    free(message);
    free(macros);
}

// Note which checks pass, and return how many of those did not pass in the whole.
static int note_passes(Grading *grading, const Variant *together)
{
    int n_saved = 0;
    for (int i = 0; i < grading->result.n_checks; i++) {
        const CheckResult *check = &grading->result.checks[i];
        CheckResult found = {.max_points = check->max_points};
        session_judge(&grading->session, 0, i, together, &found);
        grading->passes_beside[i] = found.status == CHECK_PASSED;
        n_saved += found.status == CHECK_PASSED && check->status != CHECK_PASSED;
        check_free(&found);
    }
    return n_saved;
}

int grading_try_together(Grading *grading)
{
    char folder[PATH_MAX];
    Variant together = {0};
    Variant *const variants[] = {&together};
    path_make(folder, "%s/variant-whole/lab", grading->session.workshop.folder);
    int result = answers_fill(&grading->session, "together", folder, 1, &together);
    together.is_again = grading->whole.is_endless;
    if (result == 0 && together.is_changed) {
        result = session_run(&grading->session, variants, 1);
    }
    if (result == 0 && together.is_changed && note_passes(grading, &together) > 0) {
        grading->is_saved_beside = 1;
        tell(grading);
    }
    variant_free(&together);
    return result;
}
