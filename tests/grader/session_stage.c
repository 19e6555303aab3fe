// Staging a submission so that what is there of it can be run (see session.h).
//
// One file that cannot be used costs its own tasks and no others: it is replaced by the file as it
// is handed out. Read next: submission.h.
#include "message.h"
#include "path.h"
#include "session.h"
#include "skeleton.h"
#include "submission.h"

#include <stdlib.h>
#include <unistd.h>

// Find the files that staging left out.
static void files_find(const Manifest *manifest, const Variant *variant, StagedFiles *staged)
{
    for (int i = 0; i < manifest->n_files; i++) {
        char path[PATH_MAX];
        variant_file(variant, manifest->files[i], path);
        staged->is_replaced[i] = access(path, F_OK) != 0;
        staged->n_taken += !staged->is_replaced[i];
    }
}

// Put what is handed out into the place of each file that was left out, and say so. Returns 0, or
// -1 after one message.
static int files_replace(const Manifest *manifest, const Variant *variant, StagedFiles *staged)
{
    int result = 0;
    for (int i = 0; result == 0 && i < manifest->n_files; i++) {
        const char *file = manifest->files[i];
        if (!staged->is_replaced[i]) {
            continue;
        }
        result = variant_put(variant, file, skeleton_read(manifest, file));
        char *longer = message_new("%s\n%s: replaced by the file as it was handed out, so that "
                                   "your other files count",
                                   staged->said, file);
        free(staged->said);
        staged->said = longer;
    }
    return result;
}

int session_stage(const Session *session, const char *submission, Variant *variant,
                  StagedFiles *staged)
{
    const Manifest *manifest = &session->manifest;
    char lab[PATH_MAX];
    *staged = (StagedFiles){0};
    if (variant_open(&session->workdir, "whole", variant) != 0) {
        return -1;
    }
    path_make(lab, "%s/lab", variant->folder);
    const int outcome = submission_stage(&session->workdir, submission, lab, &staged->said);
    staged->is_complete = outcome == 0;
    if (staged->said == NULL) {
        staged->said = message_new("%s", "");
    }
    files_find(manifest, variant, staged);
    // Of two versions of its only file, too, neither is the student's answer for certain.
    staged->has_nothing = outcome >= 0 && staged->n_taken == 0;
    if (outcome < 0 || (staged->n_taken > 0 && files_replace(manifest, variant, staged) != 0)) {
        free(staged->said);
        return -1;
    }
    return 0;
}
