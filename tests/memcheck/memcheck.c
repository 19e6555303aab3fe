// memcheck: run a submission's kernels under Oclgrind, which sees what a device passes over in
// silence: indices out of range, values that were never set, races, barriers that not all reach.
//
//     memcheck --lab 03 [--submission FOLDER]
//
// The lab's probe does a small job (memcheck_job.h) in the sandbox, with Oclgrind as its OpenCL
// driver; what Oclgrind writes down is reported at the student's own lines. It is a diagnosis and
// earns or costs no points. Exit status: 0 nothing found, 1 something, 2 it could not be tried.
#include "clean_text.h"
#include "complain.h"
#include "holes.h"
#include "memcheck_job.h"
#include "memcheck_passes.h"
#include "path.h"
#include "settings.h"
#include "untouched.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_CLEAN = 0, EXIT_FOUND = 1, EXIT_FAULT = 2 };

// ---- The job -----------------------------------------------------------------------------------

// Replace the judge's job by a small one. Returns 0, or -1 after one message.
static int shrink_job(const Session *session)
{
    char path[PATH_MAX];
    Sections job;
    workshop_job_path(&session->workshop, 0, path);
    if (sections_load(path, (size_t)256 << 20, &job) != 0) {
        complain("memcheck: %s: the job cannot be read", path);
        return -1;
    }
    FILE *file = fopen(path, "wb");
    int result = file ? memcheck_job_write(&job, file) : -1;
    if (file == NULL || fclose(file) != 0) {
        complain("memcheck: %s: cannot be written: %s", path, strerror(errno));
        result = -1;
    }
    sections_free(&job);
    return result;
}

// ---- Telling ----------------------------------------------------------------------------------

// Print what is left to say of what was found.
static void end_print(const Memcheck *memcheck)
{
    if (memcheck->n_told > 0) {
        printf("Oclgrind stops at the first: others may follow from it. Correct it, then try "
               "again. Oclgrind errs now and then; no points depend on it.\n");
    } else if (!memcheck->has_trouble) {
        printf("%s: Oclgrind found nothing on a small job.\n", memcheck->session.manifest.lab);
    }
}

// Say which kernels' tasks stand as they were handed out: what Oclgrind finds there is given.
static void untouched_print(const Memcheck *memcheck)
{
    const Manifest *manifest = &memcheck->session.manifest;
    int n_untouched = 0;
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        char path[PATH_MAX];
        path_make(path, "%s/%s", memcheck->folder, task->file);
        char *answer = manifest_is_host_file(task->file) ? NULL : hole_load(path, task->id);
        if (answer != NULL && answer_is_untouched(manifest, task, answer)) {
            printf("%s%s",
                   n_untouched++ ? ", " : "Not answered yet, as it was handed out: ", task->id);
        }
        free(answer);
    }
    printf("%s", n_untouched ? "\n" : "");
}

// Say what was taken, where there is something to say: to whom it helps, if nothing was.
static void staged_print(const StagedFiles *staged)
{
    char *clean = message_clean(staged->said);
    if (clean[0] != '\0') {
        fprintf(staged->n_taken > 0 ? stdout : stderr, "%s\n", clean);
    }
    free(clean);
}

// ---- All --------------------------------------------------------------------------------------

// Returns an exit status.
static int memcheck_run(Memcheck *memcheck, const Settings *settings)
{
    Session *session = &memcheck->session;
    if (session_open(session, settings) != 0 || shrink_job(session) != 0 ||
        variant_open(&session->workshop, "whole", &memcheck->whole, memcheck->folder) != 0) {
        return EXIT_FAULT;
    }
    StagedFiles staged;
    if (session_stage(session, settings->submission, memcheck->folder, &staged) != 0) {
        return EXIT_FAULT;
    }
    staged_print(&staged);
    free(staged.said);
    if (staged.n_taken == 0) {
        return EXIT_FAULT;
    }
    // Host files are compiled on the way.
    Variant *variants[] = {&memcheck->whole};
    if (session->workshop.needs_compiler && session_run(session, variants, 1) != 0) {
        return EXIT_FAULT;
    }
    if (memcheck->whole.build_log != NULL) {
        char *clean = message_clean(memcheck->whole.build_log);
        printf("It does not compile:\n%s\n", clean);
        free(clean);
        return EXIT_FAULT;
    }
    untouched_print(memcheck);
    if (memcheck_passes(memcheck) != 0) {
        return EXIT_FAULT;
    }
    end_print(memcheck);
    return memcheck->n_told > 0 || memcheck->has_trouble ? EXIT_FOUND : EXIT_CLEAN;
}

// Has the lab a kernel that a student writes?
static int has_kernels(const char *lab)
{
    Manifest manifest;
    if (manifest_load("labs", lab, &manifest) != 0) {
        return 0;
    }
    const int has = manifest_has_kernels(&manifest);
    manifest_free(&manifest);
    return has;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? EXIT_CLEAN : EXIT_FAULT;
    }
    if (!has_kernels(settings.lab)) {
        complain("memcheck: %s: found no kernel to hand in, expected one: Oclgrind looks at "
                 "kernels only",
                 settings.lab);
        return EXIT_FAULT;
    }
    if (access(OCLGRIND_DRIVER, R_OK) != 0) {
        complain("memcheck: found no Oclgrind (" OCLGRIND_DRIVER "); install the package oclgrind, "
                 "which Debian 12 has and Debian 13 has not");
        return EXIT_FAULT;
    }
    settings.device = "";  // Oclgrind's is the only one
    static Memcheck memcheck;
    const int status = memcheck_run(&memcheck, &settings);
    variant_free(&memcheck.whole);
    session_close(&memcheck.session);
    return status;
}
