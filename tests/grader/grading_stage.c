// Staging a submission, and judging what is there of it (see grading.h).
//
// One file that cannot be used costs its own tasks and no others: it is replaced by the file as it
// is handed out. Called by grade.c. Read next: submission.h.
#include "grading.h"

#include "message.h"
#include "path.h"
#include "skeleton.h"
#include "stands_out.h"
#include "submission.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Find the files that staging left out. Returns how many it took.
static int files_find(Grading *grading, const char *folder)
{
    const Manifest *manifest = &grading->session.manifest;
    int n_taken = 0;
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        path_make(path, "%s/%s", folder, manifest->files[i]);
        grading->is_replaced[i] = access(path, F_OK) != 0;
        n_taken += !grading->is_replaced[i];
    }
    return n_taken;
}

// Put what is handed out into the place of each file that was left out. Returns 0, or -1 after one
// message.
static int files_replace(const Grading *grading, const char *folder)
{
    const Manifest *manifest = &grading->session.manifest;
    int result = 0;
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        if (grading->is_replaced[i]) {
            char *text = skeleton_read(manifest, manifest->files[i]);
            result = text == NULL ? -1 : session_write(folder, manifest->files[i], text);
            free(text);
        }
    }
    return result;
}

// What staging said, and what became of the files that it left out. Owned by the caller.
static char *describe_files(const Grading *grading, const char *said)
{
    const Manifest *manifest = &grading->session.manifest;
    char *text = message_new("%s", said);
    for (int i = 0; i < manifest->n_files; i++) {
        if (grading->is_replaced[i]) {
            char *longer = message_new("%s\n%s: replaced by the file as it was handed out, so that "
                                       "your other files count",
                                       text, manifest->files[i]);
            free(text);
            text = longer;
        }
    }
    return text;
}

// Note what is about the submission as a whole.
static void add_notes(Grading *grading, const char *submission, const char *folder)
{
    char *notes = stands_out(&grading->session.manifest, folder, submission);
    if (notes != NULL) {
        grading_add_stage(grading, "What stands out", CHECK_PASSED, notes);
        free(notes);
    }
    const char *sandbox = sandbox_kind_note(grading->session.workshop.sandbox);
    if (sandbox != NULL) {
        grading_add_stage(grading, "Sandbox", CHECK_PASSED, sandbox);
    }
}

int grading_stage(Grading *grading, const char *submission, const char *folder)
{
    char *said = NULL;
    const int staged = submission_stage(&grading->session.workshop, submission, folder, &said);
    if (staged < 0) {
        return -1;
    }
    grading->result.has_nothing = staged == STAGE_NOTHING;
    const int n_taken = files_find(grading, folder);
    char *message = n_taken > 0 ? describe_files(grading, said != NULL ? said : "") : NULL;
    grading_add_stage(grading, "Staging", staged == 0 ? CHECK_PASSED : CHECK_FAILED,
                      message != NULL ? message
                      : said != NULL  ? said
                                      : "");
    free(message);
    free(said);
    if (n_taken > 0 && files_replace(grading, folder) != 0) {
        return -1;
    }
    add_notes(grading, submission, folder);
    return n_taken > 0;
}

int grading_is_replaced(const Grading *grading, const char *file)
{
    const Manifest *manifest = &grading->session.manifest;
    for (int i = 0; i < manifest->n_files; i++) {
        if (strcmp(manifest->files[i], file) == 0) {
            return grading->is_replaced[i];
        }
    }
    return 0;
}
