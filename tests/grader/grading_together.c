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

// Does a source define the macro?
static int defines(const char *source, const char *macro)
{
    SourceReader reader = source_reader(source);
    SourceWord word = source_next_macro(&reader);
    while (word.kind != SOURCE_END && strcmp(word.text, macro) != 0) {
        word = source_next_macro(&reader);
    }
    return word.kind != SOURCE_END;
}

// Add the macros that a source defines and the one that is handed out does not. Takes the list
// over.
static char *add_macros(char *list, const char *source, const char *handed_out)
{
    SourceReader reader = source_reader(source);
    for (SourceWord word = source_next_macro(&reader); word.kind != SOURCE_END;
         word = source_next_macro(&reader)) {
        if (!defines(handed_out, word.text)) {
            char *longer = message_new("%s%s%s", list, list[0] != '\0' ? ", " : "", word.text);
            free(list);
            list = longer;
        }
    }
    return list;
}

// The macros of the student's own files, "r, x"; "" for none. Owned by the caller.
static char *list_macros(const Manifest *manifest, const char *folder)
{
    char *list = message_new("%s", "");
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        path_make(path, "%s/%s", folder, manifest->files[i]);
        char *own = text_file_read(path), *handed_out = skeleton_read(manifest, manifest->files[i]);
        if (own != NULL && handed_out != NULL) {
            list = add_macros(list, own, handed_out);
        }
        free(own);
        free(handed_out);
    }
    return list;
}

static void tell(Grading *grading, const char *folder)
{
    char *macros = list_macros(&grading->session.manifest, folder);
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
    int result = answers_fill(&grading->session, "together", folder, &together);
    together.is_again = grading->whole.is_endless;
    if (result == 0 && together.is_changed) {
        result = session_run(&grading->session, variants, 1);
    }
    if (result == 0 && together.is_changed && note_passes(grading, &together) > 0) {
        tell(grading, folder);
    }
    variant_free(&together);
    return result;
}
