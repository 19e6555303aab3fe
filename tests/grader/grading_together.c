// Letting all answers run together without what stands beside them (see grading.h).
//
// Called by grade.c where the student's files do not compile, and by grading_alone.c where each
// answer is right alone, and the whole is not: what is left is a macro that reaches another task's
// lines, or what was changed outside of the marked ones. Read next: grading_macros.c.
#include "grading.h"

#include "holes.h"
#include "message.h"
#include "skeleton.h"
#include "source_words.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// An answer, and behind it the end of each macro that it defines: in another task's lines it would
// change what stands there. Takes the answer over; NULL stays NULL, and is all without memory.
static char *seal(char *answer, int *is_sealed)
{
    char *sealed = NULL;
    size_t n_bytes;
    FILE *stream = answer != NULL ? open_memstream(&sealed, &n_bytes) : NULL;
    if (stream != NULL) {
        SourceReader reader = source_reader(answer);
        fputs(answer, stream);
        for (SourceWord word = source_next_macro(&reader); word.kind != SOURCE_END;
             word = source_next_macro(&reader)) {
            fprintf(stream, "#undef %s\n", word.text);
            *is_sealed = 1;
        }
        fclose(stream);
    }
    free(answer);
    return sealed;
}

// One of the lab's files as it is handed out, with all answers of the student's file in it that can
// be put in. NULL after one message.
static char *answers_text(const Manifest *manifest, const char *file, const char *own_path,
                          int seals, int *is_sealed)
{
    char *text = skeleton_read(manifest, file);
    for (int t = 0; text != NULL && t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char *answer = strcmp(task->file, file) == 0 ? hole_load(own_path, task->id) : NULL;
        answer = seals ? seal(answer, is_sealed) : answer;
        char *filled = answer != NULL ? hole_fill(text, task->id, answer) : NULL;
        if (filled != NULL) {
            free(text);
            text = filled;
        }
        free(answer);
    }
    return text;
}

// Make a variant of all answers together, with what stands beside the marked lines left out: the
// files as they are handed out, with what is between the student's markers. Sets is_changed where
// the student's files are other than that, and is_sealed where a macro was ended. Returns 0, or -1
// after one message.
//   seals   does a macro end with the answer that defines it?
static int answers_fill(Grading *grading, const char *name, int seals, Variant *variant)
{
    const Manifest *manifest = &grading->session.manifest;
    int result = variant_open(&grading->session.workdir, name, variant);
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        char path[PATH_MAX];
        grading_own_path(grading, manifest->files[i], path);
        char *own_text = text_file_read(path);
        char *text = answers_text(manifest, manifest->files[i], path, seals, &variant->is_sealed);
        variant->is_changed |= text != NULL && own_text != NULL && strcmp(text, own_text) != 0;
        result = variant_put(variant, manifest->files[i], text);
        free(own_text);
    }
    return result;
}

// ---- In the place of the whole ------------------------------------------------------------------

// Run all answers together in the place of the whole, if they compile.
//   seals, is_sealed   see answers_fill()
// Returns 0, or -1 after one message.
static int take_answers(Grading *grading, int seals, int *is_sealed)
{
    Variant answers;
    Variant *const variants[] = {&answers};
    if (answers_fill(grading, "answers", seals, &answers) != 0 ||
        session_run(&grading->session, variants, 1) != 0) {
        variant_free(&answers);
        return -1;
    }
    *is_sealed = answers.is_sealed;
    if (answers.build_log == NULL) {
        grading->build_log =
            message_new("%s\nWhat stands between the markers compiles. The rest of these files was "
                        "replaced by what is handed out, so that it could be judged.",
                        grading->whole.build_log);
        variant_free(&grading->whole);
        grading->whole = answers;
    } else {
        variant_free(&answers);
    }
    return 0;
}

int grading_retry(Grading *grading)
{
    int is_sealed = 0, result = 0;
    if (grading->whole.build_log != NULL) {
        result = take_answers(grading, 1, &is_sealed);
    }
    if (result == 0 && grading->whole.build_log != NULL && is_sealed) {
        result = take_answers(grading, 0, &is_sealed);
    }
    return result;
}

// ---- Beside the whole ---------------------------------------------------------------------------

static void tell(Grading *grading)
{
    char *macros = grading_own_macros(grading);
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
    Variant together = {0};
    Variant *const variants[] = {&together};
    int result = answers_fill(grading, "together", 1, &together);
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
