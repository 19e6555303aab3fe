// Folders, compilers and probes: how a variant of a submission becomes answers.
#include "workshop.h"

#include "crash_line.h"
#include "folder.h"
#include "jobs.h"
#include "limited_folder.h"
#include "message.h"
#include "probe.h"
#include "run_end.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_BYTES = 512 };

// Answers are pictures of at most 336x240 pixels of 16 bytes, a dozen of them: far below this.
#define MAX_ANSWER_BYTES ((size_t)FILE_MB << 20)

static int make_folder_with(const char *path, mode_t mode)
{
    if (mkdir(path, mode) != 0 && errno != EEXIST) {
        fprintf(stderr, "grade: %s: cannot be made: %s\n", path, strerror(errno));
        return -1;
    }
    return chmod(path, mode);
}

static int make_folder(const char *path)
{
    return make_folder_with(path, 0755);
}

// Closed to all but the run that is given it: other runs may be as curious as other users.
static int make_closed_folder(const char *path)
{
    return make_folder_with(path, 0700);
}

// The folder of a variant that its compiler or its probe writes to.
static void step_folder(const Workshop *workshop, const char *variant, Step step,
                        char path[PATH_BYTES])
{
    snprintf(path, PATH_BYTES, "%s/variant-%s/%s", workshop->folder, variant,
             step == STEP_COMPILING ? "build" : "out");
}

// Remove what an earlier variant of this name wrote. Returns 0, or -1 with errno set.
static int step_folder_remove(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_BYTES];
    step_folder(workshop, variant, step, path);
    limited_folder_unmount(path);
    return folder_remove(path) != 0 && errno != ENOENT ? -1 : 0;
}

// Make it empty, closed to all but the run. Returns 0, or -1 after one message.
static int step_folder_make(const Workshop *workshop, const char *variant, Step step)
{
    char path[PATH_BYTES];
    step_folder(workshop, variant, step, path);
    if (make_closed_folder(path) != 0) {
        return -1;
    }
    limited_folder_mount(path, TOTAL_FILE_MB, N_FILES);
    return 0;
}

// Copy one of the instructor's own files.
static int copy_file(const char *from, const char *to)
{
    char block[1 << 16];
    FILE *in = fopen(from, "rb");
    FILE *out = in ? fopen(to, "wb") : NULL;
    int failed = in == NULL || out == NULL;
    size_t n;
    while (!failed && (n = fread(block, 1, sizeof block, in)) > 0) {
        failed = fwrite(block, 1, n, out) != n;
    }
    failed |= in != NULL && ferror(in);
    if (in != NULL) {
        fclose(in);
    }
    if (out != NULL) {
        failed |= fclose(out) != 0;
    }
    struct stat status;
    if (failed || stat(from, &status) != 0 || chmod(to, (status.st_mode & 0111) | 0644) != 0) {
        fprintf(stderr, "grade: %s: cannot be copied: %s\n", from, strerror(errno));
        return -1;
    }
    return 0;
}

// Copy what matches the pattern into tree/folder; that nothing does is a fault of the machinery.
static int copy_matching(const Workshop *workshop, const char *pattern, const char *folder)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/tree/%s", workshop->folder, folder);
    if (make_folder(path) != 0) {
        return -1;
    }
    glob_t found;
    if (glob(pattern, GLOB_BRACE, NULL, &found) != 0) {
        fprintf(stderr, "grade: %s: not found; run make grader in the course's top folder\n",
                pattern);
        return -1;
    }
    int result = 0;
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *name = strrchr(found.gl_pathv[i], '/') + 1;
        snprintf(path, sizeof path, "%s/tree/%s/%s", workshop->folder, folder, name);
        result = copy_file(found.gl_pathv[i], path);
    }
    globfree(&found);
    return result;
}

// The solutions of the labs before this one, as a handout has them.
static int copy_earlier_solutions(const Workshop *workshop)
{
    glob_t found;
    int result = 0;
    if (glob("solutions/*", GLOB_ONLYDIR, NULL, &found) != 0) {
        return 0;  // a handout of the first lab has none
    }
    for (size_t i = 0; result == 0 && i < found.gl_pathc; i++) {
        const char *folder = found.gl_pathv[i];
        char pattern[PATH_BYTES];
        if (strcmp(folder + strlen("solutions/"), workshop->manifest->lab) >= 0) {
            continue;
        }
        snprintf(pattern, sizeof pattern, "%s/*.[hc]*", folder);
        result = copy_matching(workshop, pattern, folder);
    }
    globfree(&found);
    return result;
}

static int copy_libraries(const Workshop *workshop)
{
    const char *lab = workshop->manifest->lab;
    char pattern[PATH_BYTES];
    snprintf(pattern, sizeof pattern, "%s/probes/%s*", workshop->build, lab);
    int result = copy_matching(workshop, pattern, "lib");
    snprintf(pattern, sizeof pattern, "%s/earlier/%s.a", workshop->build, lab);
    result |= copy_matching(workshop, pattern, "lib/earlier");
    snprintf(pattern, sizeof pattern, "%s/libcommon.a", workshop->build);
    return result | copy_matching(workshop, pattern, "lib");
}

// The kernels of the lab's probe; a lab of host files alone has none.
static int copy_probe_kernel(const Workshop *workshop)
{
    char from[PATH_BYTES], folder[128];
    snprintf(folder, sizeof folder, "probes/%s", workshop->manifest->lab);
    snprintf(from, sizeof from, "tests/%s/probe.cl", folder);
    return access(from, F_OK) == 0 ? copy_matching(workshop, from, folder) : 0;
}

// Empty folders that the sandbox puts others in the place of.
static int make_mount_points(const Workshop *workshop)
{
    static const char *const folders[] = {"labs", "job", "build", "out"};
    char path[PATH_BYTES];
    int result = 0;
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        snprintf(path, sizeof path, "%s/tree/%s", workshop->folder, folders[i]);
        result |= make_folder(path);
    }
    snprintf(path, sizeof path, "%s/tree/labs/%s", workshop->folder, workshop->manifest->lab);
    result |= make_folder(path);
    snprintf(path, sizeof path, "%s/job", workshop->folder);
    return result | make_folder(path);
}

int workshop_open(Workshop *workshop, const Manifest *manifest, const char *build,
                  const char *device, SandboxKind sandbox)
{
    *workshop =
        (Workshop){.build = build, .manifest = manifest, .device = device, .sandbox = sandbox};
    workshop->needs_compiler = manifest_has_host_files(manifest);
    if (temporary_folder_make(workshop->folder, sizeof workshop->folder, "grade") != 0) {
        fprintf(stderr, "grade: no temporary folder in $TMPDIR or /tmp: %s\n", strerror(errno));
        return -1;
    }
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/tree", workshop->folder);
    int result = make_folder(workshop->folder) | make_folder(path);
    snprintf(path, sizeof path, "%s/tree/solutions", workshop->folder);
    result |= make_folder(path) | make_mount_points(workshop);
    result |= copy_matching(workshop, "common/*.h", "common");
    result |= copy_matching(workshop, "kernels/*.h", "kernels");
    result |= copy_matching(workshop, "tests/probes/*.h", "probes");
    return result | copy_probe_kernel(workshop) | copy_earlier_solutions(workshop) |
                   copy_libraries(workshop)
               ? -1
               : 0;
}

void workshop_close(Workshop *workshop)
{
    glob_t found;
    char pattern[PATH_BYTES];
    snprintf(pattern, sizeof pattern, "%s/variant-*/{build,out}", workshop->folder);
    if (workshop->folder[0] != '\0' && glob(pattern, GLOB_BRACE, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc; i++) {
            limited_folder_unmount(found.gl_pathv[i]);
        }
        globfree(&found);
    }
    if (workshop->folder[0] != '\0') {
        folder_remove(workshop->folder);
    }
    workshop->folder[0] = '\0';
}

void workshop_job_path(const Workshop *workshop, char *path, size_t n_bytes)
{
    snprintf(path, n_bytes, "%s/job/job", workshop->folder);
}

void variant_job_path(const Workshop *workshop, const Variant *variant, char *path, size_t n_bytes)
{
    snprintf(path, n_bytes, "%s/variant-%s/job/job", workshop->folder, variant->name);
}

// ---- Variants -----------------------------------------------------------------------------------

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
    *variant = (Variant){0};
}

// The folders of a variant as mounts; paths[] keeps the strings.
static void mount_variant(const Workshop *workshop, const Variant *variant, int building,
                          char paths[5][PATH_BYTES], char *lab_inside, SandboxCommand *command)
{
    snprintf(paths[0], PATH_BYTES, "%s/tree", workshop->folder);
    snprintf(paths[1], PATH_BYTES, "%s/variant-%s/lab", workshop->folder, variant->name);
    snprintf(paths[2], PATH_BYTES, "%s/variant-%s/build", workshop->folder, variant->name);
    snprintf(paths[3], PATH_BYTES, "%s/variant-%s/out", workshop->folder, variant->name);
    snprintf(paths[4], PATH_BYTES, variant->alone ? "%1$s/variant-%2$s/job" : "%1$s/job",
             workshop->folder, variant->name);
    snprintf(lab_inside, PATH_BYTES, "/work/labs/%s", workshop->manifest->lab);
    const SandboxMount mounts[] = {
        {paths[0], "/work", 0},
        {paths[1], lab_inside, 0},
        {paths[2], "/work/build", building},
        {paths[3], "/work/out", !building},
        {paths[4], "/work/job", 0},
    };
    memcpy(command->mounts, mounts, sizeof mounts);
    // The compiler needs neither the job nor a place for answers.
    command->n_mounts = building ? 3 : 5;
}

static SandboxRun *start(const Workshop *workshop, const Variant *variant, int building,
                         const char *const *argv, SandboxTime time)
{
    char paths[5][PATH_BYTES], lab_inside[PATH_BYTES], device[PATH_BYTES];
    snprintf(device, sizeof device, CL_DEVICE_VARIABLE "=%s", workshop->device);
    // PoCL takes groups of 4096, GPUs often no more than 256: what is graded here shall run there.
    // One thread: an endless loop then keeps one processor busy, not all of them.
    const char *const environment[] = {device,
                                       "POCL_MAX_WORK_GROUP_SIZE=256",
                                       "POCL_MAX_PTHREAD_COUNT=1",
                                       "POCL_CPU_MAX_CU_COUNT=1",
                                       CRASH_LINE_OPTIONS,
                                       NULL};
    SandboxCommand command = {
        .kind = workshop->sandbox,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .time = time,
        // The address sanitizer reserves terabytes that it never uses; what is in use is still
        // counted.
        .memory_mb = variant->is_checked && !building ? 0 : MEMORY_MB,
        .file_mb = FILE_MB,
        .n_processes = N_PROCESSES,
        .total_memory_mb = TOTAL_MEMORY_MB,
        .total_file_mb = TOTAL_FILE_MB,
        .n_files = N_FILES,
    };
    mount_variant(workshop, variant, building, paths, lab_inside, &command);
    return sandbox_start(&command);
}

// The compiler's command line for the lab's host files, the probe and the libraries.
static SandboxRun *start_compiler(const Workshop *workshop, const Variant *variant,
                                  SandboxTime time)
{
    const Manifest *manifest = workshop->manifest;
    enum { MAX_WORDS = 64 };
    const char *argv[MAX_WORDS] = {"/usr/bin/gcc", "-std=c11", "-D_GNU_SOURCE", "-O2",      "-g",
                                   "-Wall",        "-Wextra",  "-Icommon",      "-Ikernels"};
    char words[MAX_WORDS][PATH_BYTES];
    int n = 9, n_words = 0;
    snprintf(words[n_words], PATH_BYTES, "-Ilabs/%s", manifest->lab);
    argv[n++] = words[n_words++];
    glob_t found;
    if (glob("solutions/*", GLOB_ONLYDIR, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc && n < MAX_WORDS / 2; i++) {
            if (strcmp(found.gl_pathv[i] + strlen("solutions/"), manifest->lab) < 0) {
                snprintf(words[n_words], PATH_BYTES, "-I%s", found.gl_pathv[i]);
                argv[n++] = words[n_words++];
            }
        }
        globfree(&found);
    }
    for (int i = 0; i < manifest->n_files; i++) {
        const char *name = manifest->files[i];
        if (manifest_is_host_file(name)) {
            snprintf(words[n_words], PATH_BYTES, "labs/%s/%s", manifest->lab, name);
            argv[n++] = words[n_words++];
        }
    }
    const char *const libraries[] = {"lib/%s.a", "lib/earlier/%s.a"};
    for (int i = 0; i < 2; i++) {
        snprintf(words[n_words], PATH_BYTES, libraries[i], manifest->lab);
        argv[n++] = words[n_words++];
    }
    if (variant->is_checked) {
        argv[n++] = "-fsanitize=address";
        argv[n++] = "-fno-omit-frame-pointer";
        argv[n++] = "-fno-optimize-sibling-calls";
    }
    const char *const rest[] = {"lib/libcommon.a", "-lOpenCL", "-lm", "-o", "build/probe"};
    memcpy(argv + n, rest, sizeof rest);
    return start(workshop, variant, 1, argv, time);
}

static SandboxRun *start_probe(const Workshop *workshop, const Variant *variant, SandboxTime time)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "lib/%s", workshop->manifest->lab);
    const char *const argv[] = {workshop->needs_compiler ? "build/probe" : path, NULL};
    return start(workshop, variant, 0, argv, time);
}

// Why the compiler came to no end of its own.
static char *describe_compiler_end(const SandboxResult *result, SandboxTime allowed)
{
    if (result->outcome == SANDBOX_TIMED_OUT) {
        return message_new("the compiler did not finish in time: it used up the %.1f s of "
                           "processor time that are allowed; too large a program?",
                           allowed.processor);
    }
    char *end = run_end_describe(result, allowed);
    char *message = message_new("the compiler did not finish: %s", end);
    free(end);
    return message;
}

// What a compiler's end says about the variant.
static void take_build(Variant *variant, SandboxResult *result, SandboxTime allowed)
{
    if (result->outcome != SANDBOX_EXITED) {
        variant->build_log = describe_compiler_end(result, allowed);
    } else if (result->exit_status != 0) {
        variant->build_log = result->output;
        result->output = NULL;
    }
}

// Where the probe says it was.
static void take_place(const Workshop *workshop, Variant *variant)
{
    char path[PATH_BYTES];
    Sections job;
    snprintf(path, sizeof path, "%s/variant-%s/out/note", workshop->folder, variant->name);
    const ProbeNote note = run_note_load(path);
    if (variant->alone) {
        return;  // nothing of it is told
    }
    workshop_job_path(workshop, path, sizeof path);
    if (sections_load(path, (size_t)256 << 20, &job) == 0) {
        variant->place = run_place_find(workshop->manifest->lab, &job, &note);
    }
    sections_free(&job);
}

// What a probe's end and answers say about the variant.
static void take_answers(const Workshop *workshop, Variant *variant, SandboxResult *result,
                         SandboxTime allowed)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/variant-%s/out/answers", workshop->folder, variant->name);
    sections_load(path, MAX_ANSWER_BYTES, &variant->answers);
    variant->run_output = strdup(result->output);
    if (result->outcome == SANDBOX_EXITED && result->exit_status == PROBE_EXIT_NO_BUILD) {
        variant->build_log = strdup(variant->run_output);
        return;
    }
    variant->trouble = run_end_describe(result, allowed);
    variant->habits = run_habits_describe(result);
    size_t n_bytes;
    if (variant->trouble == NULL &&
        sections_find_any(&variant->answers, PROBE_END, &n_bytes) == NULL) {
        variant->trouble = message_new("it ended by itself, with exit status 0, before it had "
                                       "answered everything: a call of exit()?");
    }
    variant->has_crashed = result->outcome == SANDBOX_CRASHED && result->signal != SIGXFSZ &&
                           result->signal != SIGKILL;
    if (variant->trouble != NULL) {
        take_place(workshop, variant);
    }
}

// ---- Both steps, side by side ---------------------------------------------------------------

static SandboxTime time_allowed(const Variant *variant, Step step, const Allowance *allowance)
{
    return variant->is_ours ? allowance_ours() : allowance_of(allowance, step);
}

static int step_start(const Workshop *workshop, Variant *variant, Step step,
                      const Allowance *allowance)
{
    const SandboxTime time = time_allowed(variant, step, allowance);
    variant->run = step == STEP_COMPILING ? start_compiler(workshop, variant, time)
                                          : start_probe(workshop, variant, time);
    return variant->run != NULL ? 0 : -1;
}

// Make anew what a step writes to: behind Landlock the old files belong to a user that is gone.
// Returns 0, or -1 after one message.
static int step_clear(const Workshop *workshop, const Variant *variant, Step step)
{
    return step_folder_remove(workshop, variant->name, step) != 0
               ? -1
               : step_folder_make(workshop, variant->name, step);
}

// Wait for a variant's step, which is started again where the machine had no time for it. Returns
// 0, or -1 after one message when the machinery failed.
static int step_take(const Workshop *workshop, Variant *variant, Step step, Allowance *allowance)
{
    enum { TRIES = 2 };
    SandboxResult result = {.outcome = SANDBOX_FAULT};
    // The line of a crash is not worth a second try.
    const int n_tries = variant->is_checked ? 1 : TRIES;
    for (int i = 0; i < n_tries; i++) {
        if (i > 0) {
            free(result.output);
            if (step_clear(workshop, variant, step) != 0 ||
                step_start(workshop, variant, step, allowance) != 0) {
                return -1;
            }
        }
        result = sandbox_wait(variant->run);
        variant->run = NULL;
        if (result.outcome != SANDBOX_STARVED) {
            break;
        }
    }
    int failed = result.outcome == SANDBOX_FAULT || result.outcome == SANDBOX_STARVED;
    if (failed && variant->is_checked) {
        free(result.output);
        return -1;  // in silence: only the line of a crash is not known then
    }
    if (result.outcome == SANDBOX_FAULT) {
        fprintf(stderr, "grade: the sandbox failed: %s\n", result.output);
    } else if (result.outcome == SANDBOX_STARVED) {
        fprintf(stderr,
                "grade: this machine is too busy: twice it had %.1f s of processor time for %s in "
                "%.0f s; grade again when it is less so\n",
                result.used.processor, step == STEP_COMPILING ? "compiling" : "running the program",
                result.used.wall);
    } else if (step == STEP_COMPILING) {
        take_build(variant, &result, time_allowed(variant, step, allowance));
    } else {
        take_answers(workshop, variant, &result, time_allowed(variant, step, allowance));
        if (!variant->is_checked) {
            step_folder_remove(workshop, variant->name, step);  // in memory, perhaps
        }
    }
    if (!failed && variant->is_ours) {
        allowance_note(allowance, step, result.used);
    }
    free(result.output);
    return failed ? -1 : 0;
}

// Run a step of those variants that compile, side by side.
static int step_run(const Workshop *workshop, Variant *const variants[], int n, Step step,
                    Allowance *allowance)
{
    int result = 0;
    for (int i = 0; i < n; i++) {
        if (variants[i]->build_log == NULL) {
            result |= step_start(workshop, variants[i], step, allowance);
        }
    }
    for (int i = 0; i < n; i++) {
        if (variants[i]->run == NULL) {
            continue;
        }
        // What ours took, ahead of it, may have become known since it was started.
        sandbox_allow(variants[i]->run, time_allowed(variants[i], step, allowance));
        result |= step_take(workshop, variants[i], step, allowance);
    }
    return result;
}

int variants_run(const Workshop *workshop, Variant *const variants[], int n, Allowance *allowance)
{
    const int compiled =
        workshop->needs_compiler ? step_run(workshop, variants, n, STEP_COMPILING, allowance) : 0;
    return compiled != 0 ? -1 : step_run(workshop, variants, n, STEP_RUNNING, allowance);
}

// ---- The line of a crash ------------------------------------------------------------------------

char *variant_find_line(const Workshop *workshop, const Variant *variant, Allowance *allowance)
{
    char out[PATH_BYTES], lab[PATH_BYTES];
    Variant checked = {.is_checked = 1};
    Variant *const variants[] = {&checked};
    memcpy(checked.name, variant->name, sizeof checked.name);
    if (!workshop->needs_compiler || step_clear(workshop, variant, STEP_COMPILING) != 0 ||
        step_clear(workshop, variant, STEP_RUNNING) != 0 ||
        variants_run(workshop, variants, 1, allowance) != 0) {
        return NULL;
    }
    snprintf(out, sizeof out, "%s/variant-%s/out", workshop->folder, variant->name);
    snprintf(lab, sizeof lab, "%s/variant-%s/lab", workshop->folder, variant->name);
    char *line = checked.trouble != NULL ? crash_line_find(out, lab, workshop->manifest) : NULL;
    variant_free(&checked);
    return line;
}
