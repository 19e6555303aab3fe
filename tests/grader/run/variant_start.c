// Starting a variant's compiler and its probe in a sandbox.
#include "variant_steps.h"

#include "crash_line.h"
#include "path.h"
#include "probe.h"
#include "run_end.h"

#include <glob.h>
#include <stdio.h>
#include <string.h>

static SandboxRun *start(const Workdir *workdir, const Variant *variant, int building,
                         const char *const *argv, SandboxTime time)
{
    char lab[PATH_MAX], inside[PATH_MAX], build[PATH_MAX], out[PATH_MAX], job[PATH_MAX],
        device[PATH_MAX];
    path_make(lab, "%s/lab", variant->folder);
    path_make(inside, "/work/labs/%s", workdir->manifest->lab);
    path_make(build, "%s/build", variant->folder);
    path_make(out, "%s/out", variant->folder);
    path_make(job, "%s/job", variant->alone ? variant->folder : workdir->folder);
    snprintf(device, sizeof device, CL_DEVICE_VARIABLE "=%s", workdir->device);
    // PoCL takes groups of 4096, GPUs often no more than 256: what is graded here shall run there.
    // One thread: an endless loop then keeps one processor busy, not all of them.
    const char *environment[8] = {device, "POCL_MAX_WORK_GROUP_SIZE=256",
                                  "POCL_MAX_PTHREAD_COUNT=1", "POCL_CPU_MAX_CU_COUNT=1",
                                  CRASH_LINE_OPTIONS};
    int n = 0;
    while (environment[n] != NULL) {
        n++;
    }
    if (variant->has_only_kernels) {
        environment[n++] = PROBE_KERNELS_VARIABLE "=1";
    }
    if (variant->is_second) {
        environment[n++] = SECOND_COMPILER;
    }
    SandboxCommand command = workdir_command(workdir, argv, environment, time);
    const SandboxMount mounts[] = {
        {lab, inside, 0},
        {build, "/work/build", building},
        {out, "/work/out", !building},
        {job, "/work/job", 0},
    };
    // The compiler needs neither the job nor a place for answers.
    memcpy(command.mounts + 1, mounts, sizeof mounts);
    command.n_mounts = building ? 3 : 5;
    // The address sanitizer reserves terabytes that it never uses; what is in use is still counted.
    if (variant->purpose == VARIANT_CRASH && !building) {
        command.memory_mb = 0;
    }
    return sandbox_start(&command);
}

// The compiler's command line for the lab's host files, the probe and the libraries.
static SandboxRun *start_compiler(const Workdir *workdir, const Variant *variant, SandboxTime time)
{
    const Manifest *manifest = workdir->manifest;
    enum { MAX_WORDS = 64 };
    const char *argv[MAX_WORDS] = {
        "/usr/bin/gcc", "-std=c11", "-D_GNU_SOURCE", "-O2",      "-fno-tree-slp-vectorize",
        "-g",           "-Wall",    "-Wextra",       "-Icommon", "-Ikernels"};
    char words[MAX_WORDS][PATH_MAX];
    int n = 10, n_words = 0;
    path_make(words[n_words], "-Ilabs/%s", manifest->lab);
    argv[n++] = words[n_words++];
    glob_t found;
    if (glob("solutions/*", GLOB_ONLYDIR, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc && n < MAX_WORDS / 2; i++) {
            if (strcmp(found.gl_pathv[i] + strlen("solutions/"), manifest->lab) < 0) {
                path_make(words[n_words], "-I%s", found.gl_pathv[i]);
                argv[n++] = words[n_words++];
            }
        }
        globfree(&found);
    }
    // The probe comes first: what is defined once more is the student's to mend.
    path_make(words[n_words], "lib/%s.o", manifest->lab);
    argv[n++] = words[n_words++];
    for (int i = 0; i < manifest->n_files; i++) {
        const char *name = manifest->files[i];
        if (manifest_is_host_file(name)) {
            path_make(words[n_words], "labs/%s/%s", manifest->lab, name);
            argv[n++] = words[n_words++];
        }
    }
    path_make(words[n_words], "lib/earlier/%s.a", manifest->lab);
    argv[n++] = words[n_words++];
    if (variant->purpose == VARIANT_CRASH) {
        argv[n++] = "-fsanitize=address";
        argv[n++] = "-fno-omit-frame-pointer";
        argv[n++] = "-fno-optimize-sibling-calls";
    }
    const char *const rest[] = {"lib/libcommon.a", "-lOpenCL", "-lm", "-o", "build/probe"};
    memcpy(argv + n, rest, sizeof rest);
    return start(workdir, variant, 1, argv, time);
}

static SandboxRun *start_probe(const Workdir *workdir, const Variant *variant, SandboxTime time)
{
    // The first job comes last: how the probe ends there is how the variant does. An endless loop
    // in one job leaves the others their share of the time.
    static const char all_jobs[] =
        "for job in $(seq -f .%.0f \"$2\"); do\n"
        "    (ulimit -t \"$3\" && " PROBE_JOB_VARIABLE "=$job exec \"$1\")\n"
        "done\n"
        "exec \"$1\"\n";
    char path[PATH_MAX], n_further[16], share[16];
    const int is_race = variant->purpose == VARIANT_RACE;
    path_make(path, is_race ? "lib/%s-race" : "lib/%s", workdir->manifest->lab);
    snprintf(n_further, sizeof n_further, "%d", workdir->n_further_jobs);
    snprintf(share, sizeof share, "%.0f", time.processor / (1 + workdir->n_further_jobs));
    const int is_built_here = workdir->needs_compiler && !is_race;
    const char *const probe = is_built_here ? "build/probe" : path;
    const char *const once[] = {probe, NULL};
    const char *const often[] = {"/bin/sh", "-c", all_jobs, "probe", probe, n_further, share, NULL};
    const int is_once = workdir->n_further_jobs == 0 || variant->alone != NULL || is_race;
    return start(workdir, variant, 0, is_once ? once : often, time);
}

SandboxRun *step_sandbox(const Workdir *workdir, const Variant *variant, Step step,
                         SandboxTime time)
{
    return step == STEP_COMPILING ? start_compiler(workdir, variant, time)
                                  : start_probe(workdir, variant, time);
}
