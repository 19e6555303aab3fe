// A variant's folders and files.
#include "variant.h"

#include "folder.h"
#include "limited_folder.h"
#include "path.h"
#include "run_end.h"
#include "variant_steps.h"
#include "workdir_files.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The folder that its compiler or its probe writes to.
static void step_folder(const Variant *variant, Step step, char path[PATH_MAX])
{
    path_make(path, "%s/%s", variant->folder, step == STEP_COMPILING ? "build" : "out");
}

// Remove a folder that may not be there. Returns 0, or -1 after one message.
static int remove_folder(const char *path)
{
    if (folder_remove(path) != 0 && errno != ENOENT) {
        fprintf(stderr, "grade: %s: cannot be removed: %s\n", path, strerror(errno));
        return -1;
    }
    return 0;
}

int step_folder_remove(const Variant *variant, Step step)
{
    char path[PATH_MAX];
    step_folder(variant, step, path);
    limited_folder_unmount(path);
    return remove_folder(path);
}

int step_folder_make(const Variant *variant, Step step)
{
    char path[PATH_MAX];
    step_folder(variant, step, path);
    if (step_folder_remove(variant, step) != 0 || make_closed_folder(path) != 0) {
        return -1;
    }
    limited_folder_mount(path, TOTAL_FILE_MB, N_FILES);
    return 0;
}

// What the lab gives: a variant brings the files that students hand in.
static int copy_given_files(const Manifest *manifest, const Variant *variant)
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
        if (manifest_file(manifest, name) < 0 && strcmp(name, "main.c") != 0) {
            variant_file(variant, name, path);
            result = copy_file(found.gl_pathv[i], path);
        }
    }
    globfree(&found);
    return result;
}

int variant_open(const Workdir *workdir, const char *name, Variant *variant)
{
    static unsigned n_variants;
    char job[PATH_MAX], lab[PATH_MAX];
    *variant = (Variant){.number = ++n_variants};
    snprintf(variant->name, sizeof variant->name, "%s", name);
    path_make(variant->folder, "%s/variant-%s", workdir->folder, name);
    path_make(job, "%s/job", variant->folder);
    path_make(lab, "%s/lab", variant->folder);
    // Of an earlier variant of this name nothing may stay: behind Landlock its answers belong to a
    // user that is gone, and nobody could overwrite them.
    return step_folder_remove(variant, STEP_COMPILING) != 0 ||
                   step_folder_remove(variant, STEP_RUNNING) != 0 ||
                   remove_folder(variant->folder) != 0 || make_folder(variant->folder) != 0 ||
                   step_folder_make(variant, STEP_COMPILING) != 0 ||
                   step_folder_make(variant, STEP_RUNNING) != 0 || make_closed_folder(job) != 0 ||
                   make_closed_folder(lab) != 0
               ? -1
               : copy_given_files(workdir->manifest, variant);
}

void variant_file(const Variant *variant, const char *file, char path[PATH_MAX])
{
    path_make(path, "%s/lab/%s", variant->folder, file);
}

int variant_put(const Variant *variant, const char *file, char *text)
{
    char path[PATH_MAX];
    variant_file(variant, file, path);
    const int result = text != NULL ? write_file(path, text) : -1;
    free(text);
    return result;
}

int variant_reset(Variant *variant)
{
    Variant fresh = {.number = variant->number, .purpose = variant->purpose};
    memcpy(fresh.name, variant->name, sizeof fresh.name);
    memcpy(fresh.folder, variant->folder, sizeof fresh.folder);
    variant_free(variant);
    *variant = fresh;
    return step_folder_make(variant, STEP_COMPILING) | step_folder_make(variant, STEP_RUNNING);
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

void variant_job_path(const Variant *variant, char path[PATH_MAX])
{
    path_make(path, "%s/job/job", variant->folder);
}
