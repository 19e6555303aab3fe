// A variant's folders and files.
#include "variant.h"

#include "folder.h"
#include "limited_folder.h"
#include "path.h"
#include "run_end.h"
#include "variant_steps.h"
#include "workshop_files.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The folder of a variant that its compiler or its probe writes to.
static void step_folder(const Workshop *workshop, const char *variant, Step step,
                        char path[PATH_MAX])
{
    path_make(path, "%s/variant-%s/%s", workshop->folder, variant,
              step == STEP_COMPILING ? "build" : "out");
}

int step_folder_remove(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_MAX];
    step_folder(workshop, variant, step, path);
    limited_folder_unmount(path);
    if (folder_remove(path) != 0 && errno != ENOENT) {
        fprintf(stderr, "grade: %s: cannot be removed: %s\n", path, strerror(errno));
        return -1;
    }
    return 0;
}

int step_folder_make(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_MAX];
    step_folder(workshop, variant, step, path);
    if (make_closed_folder(path) != 0) {
        return -1;
    }
    limited_folder_mount(path, TOTAL_FILE_MB, N_FILES);
    return 0;
}

int step_clear(const Workshop *workshop, const char *variant, Step step)
{
    return step_folder_remove(workshop, variant, step) != 0
               ? -1
               : step_folder_make(workshop, variant, step);
}

// Is the file handed in by students? Then a variant brings its own.
static int is_handed_in(const Manifest *manifest, const char *name)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (strcmp(manifest->files[i], name) == 0) {
            return 1;
        }
    }
    return 0;
}

static int copy_given_files(const Manifest *manifest, const char *folder)
{
    char path[PATH_MAX];
    glob_t found;
    path_make(path, "labs/%s/*.[hc]*", manifest->lab);
    if (glob(path, 0, NULL, &found) != 0) {
        fprintf(stderr, "grade: labs/%s: not found\n", manifest->lab);
        return -1;
    }
    int result = 0;
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        if (!is_handed_in(manifest, name) && strcmp(name, "main.c") != 0) {
            path_make(path, "%s/%s", folder, name);
            result = copy_file(found.gl_pathv[i], path);
        }
    }
    globfree(&found);
    return result;
}

int variant_open(const Workshop *workshop, const char *name, Variant *variant, char path[PATH_MAX])
{
    static const char *const folders[] = {"/job", "/lab"};
    static unsigned n_variants;
    *variant = (Variant){.number = ++n_variants};
    snprintf(variant->name, sizeof variant->name, "%s", name);
    // Of an earlier variant of this name nothing may stay: behind Landlock its answers belong to a
    // user that is gone, and nobody could overwrite them.
    path_make(path, "%s/variant-%s", workshop->folder, name);
    if (step_folder_remove(workshop, name, STEP_COMPILING) != 0 ||
        step_folder_remove(workshop, name, STEP_RUNNING) != 0) {
        return -1;
    }
    if (folder_remove(path) != 0 && errno != ENOENT) {
        fprintf(stderr, "grade: %s: cannot be removed: %s\n", path, strerror(errno));
        return -1;
    }
    if (make_folder(path) != 0 || step_folder_make(workshop, name, STEP_COMPILING) != 0 ||
        step_folder_make(workshop, name, STEP_RUNNING) != 0) {
        return -1;
    }
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        path_make(path, "%s/variant-%s%s", workshop->folder, name, folders[i]);
        if (make_closed_folder(path) != 0) {
            return -1;
        }
    }
    return copy_given_files(workshop->manifest, path);
}

int variant_reset(const Workshop *workshop, Variant *variant)
{
    Variant fresh = {.number = variant->number, .purpose = variant->purpose};
    memcpy(fresh.name, variant->name, sizeof fresh.name);
    variant_free(variant);
    *variant = fresh;
    return step_clear(workshop, variant->name, STEP_COMPILING) |
           step_clear(workshop, variant->name, STEP_RUNNING);
}

void variant_free(Variant *variant)
{
    free(variant->build_log);
    free(variant->warnings);
    free(variant->trouble);
    free(variant->habits);
    free(variant->run_output);
    sections_free(&variant->answers);
    for (int i = 0; i < MAX_FURTHER_JOBS; i++) {
        sections_free(&variant->further[i]);
    }
    *variant = (Variant){0};
}

void variant_job_path(const Workshop *workshop, const Variant *variant, char path[PATH_MAX])
{
    path_make(path, "%s/variant-%s/job/job", workshop->folder, variant->name);
}
