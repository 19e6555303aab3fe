// Staging a submission, and noting what it says (see grading.h). Called by grade.c. Read next:
// session_stage.c.
#include "grading.h"

#include "path.h"
#include "stands_out.h"

#include <stdlib.h>
#include <string.h>

// Note what is about the submission as a whole.
static void add_notes(Grading *grading, const char *submission, const char *folder)
{
    char *notes = stands_out(&grading->session.manifest, folder, submission);
    if (notes != NULL) {
        result_add_stage(&grading->result, "What stands out", CHECK_PASSED, notes);
        free(notes);
    }
    const char *sandbox = sandbox_kind_note(grading->session.workdir.sandbox);
    if (sandbox != NULL) {
        result_add_stage(&grading->result, "Sandbox", CHECK_PASSED, sandbox);
    }
}

void grading_own_path(const Grading *grading, const char *file, char path[PATH_MAX])
{
    // That of the whole, also where something else has run in its place.
    path_make(path, "%s/variant-whole/lab%s%s", grading->session.workdir.folder,
              file[0] != '\0' ? "/" : "", file);
}

int grading_stage(Grading *grading, const char *submission)
{
    StagedFiles staged;
    char folder[PATH_MAX];
    if (session_stage(&grading->session, submission, &grading->whole, &staged) != 0) {
        return -1;
    }
    grading_own_path(grading, "", folder);
    grading->result.has_nothing = staged.has_nothing;
    memcpy(grading->is_replaced, staged.is_replaced, sizeof grading->is_replaced);
    result_add_stage(&grading->result, "Staging", staged.is_complete ? CHECK_PASSED : CHECK_FAILED,
                     staged.said);
    free(staged.said);
    add_notes(grading, submission, folder);
    return staged.n_taken > 0;
}

int grading_is_replaced(const Grading *grading, const char *file)
{
    const int i = manifest_file(&grading->session.manifest, file);
    return i >= 0 && grading->is_replaced[i];
}
