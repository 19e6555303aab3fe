// A submission in the folder "from" and a staging area in "to", for the tests of staging.
#ifndef UNIT_STAGED_FILES_H
#define UNIT_STAGED_FILES_H

#include "stage.h"
#include "surroundings.h"

static inline void two_folders_enter(void)
{
    folder_enter();
    cr_assert_eq(mkdir("from", 0755), 0);
    cr_assert_eq(mkdir("to", 0755), 0);
}

// Stage one folder.
static inline int folder_stage(const Manifest *manifest, const char *from, const char *to,
                               char **message)
{
    return stage_submission(manifest, &(StageSource){.folder = from}, 1, to, message);
}

// Stage a submission of this one file.
static inline int stage(const char *file, char **message)
{
    Manifest manifest = {.files = {(char *)file}, .n_files = 1};
    return folder_stage(&manifest, "from", "to", message);
}

static inline void expect_refused(const char *file, const char *reason)
{
    char *message = NULL;
    cr_expect_gt(stage(file, &message), 0);
    cr_assert_not_null(message);
    cr_expect_eq(strncmp(message, file, strlen(file)), 0, "file not named: %s", message);
    cr_expect_not_null(strstr(message, reason), "no \"%s\" in \"%s\"", reason, message);
    cr_expect_neq(message[strlen(message) - 1], '\n');
    free(message);

    char path[64];
    snprintf(path, sizeof path, "to/%s", file);
    cr_expect_neq(access(path, F_OK), 0, "staged all the same");
}

#endif
