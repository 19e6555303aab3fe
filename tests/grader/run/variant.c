// A variant's folders and files.
#include "variant.h"

#include "folder.h"
#include "limited_folder.h"
#include "run_end.h"
#include "variant_steps.h"
#include "workshop_files.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_BYTES = 512 };

// The folder of a variant that its compiler or its probe writes to.
static void step_folder(const Workshop *workshop, const char *variant, Step step,
                        char path[PATH_BYTES])
{
    snprintf(path, PATH_BYTES, "%s/variant-%s/%s", workshop->folder, variant,
             step == STEP_COMPILING ? "build" : "out");
}

int step_folder_remove(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_BYTES];
    step_folder(workshop, variant, step, path);
    limited_folder_unmount(path);
    return folder_remove(path) != 0 && errno != ENOENT ? -1 : 0;
}

int step_folder_make(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_BYTES];
    step_folder(workshop, variant, step, path);
    if (make_closed_folder(path) != 0) {
        return -1;
    }
    limited_folder_mount(path, TOTAL_FILE_MB, N_FILES);
    return 0;
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
    char path[PATH_BYTES];
    glob_t found;
    snprintf(path, sizeof path, "labs/%s/*.[hc]*", manifest->lab);
    if (glob(path, 0, NULL, &found) != 0) {
        fprintf(stderr, "grade: labs/%s: not found\n", manifest->lab);
        return -1;
    }
    int result = 0;
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        if (!is_handed_in(manifest, name) && strcmp(name, "main.c") != 0) {
            snprintf(path, sizeof path, "%s/%s", folder, name);
            result = copy_file(found.gl_pathv[i], path);
        }
    }
    globfree(&found);
    return result;
}

int variant_open(const Workshop *workshop, const char *name, Variant *variant, char *path,
                 size_t n_bytes)
{
    static const char *const folders[] = {"/job", "/lab"};
    static unsigned n_variants;
    *variant = (Variant){.number = ++n_variants};
    snprintf(variant->name, sizeof variant->name, "%s", name);
    // Of an earlier variant of this name nothing may stay: behind Landlock its answers belong to a
    // user that is gone, and nobody could overwrite them.
    snprintf(path, n_bytes, "%s/variant-%s", workshop->folder, name);
    if (step_folder_remove(workshop, name, STEP_COMPILING) != 0 ||
        step_folder_remove(workshop, name, STEP_RUNNING) != 0 ||
        (folder_remove(path) != 0 && errno != ENOENT)) {
        fprintf(stderr, "grade: %s: cannot be removed: %s\n", path, strerror(errno));
        return -1;
    }
    if (make_folder(path) != 0 || step_folder_make(workshop, name, STEP_COMPILING) != 0 ||
        step_folder_make(workshop, name, STEP_RUNNING) != 0) {
        return -1;
    }
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        snprintf(path, n_bytes, "%s/variant-%s%s", workshop->folder, name, folders[i]);
        if (make_closed_folder(path) != 0) {
            return -1;
        }
    }
    return copy_given_files(workshop->manifest, path);
}

void variant_free(Variant *variant)
{
    free(variant->build_log);
    free(variant->trouble);
    free(variant->habits);
    free(variant->run_output);
    sections_free(&variant->answers);
    for (int i = 0; i < MAX_FURTHER_JOBS; i++) {
        sections_free(&variant->further[i]);
    }
    *variant = (Variant){0};
}

void variant_job_path(const Workshop *workshop, const Variant *variant, char *path, size_t n_bytes)
{
    snprintf(path, n_bytes, "%s/variant-%s/job/job", workshop->folder, variant->name);
}
