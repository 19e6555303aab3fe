// Oclgrind's passes over a submission's probe (see memcheck_passes.h).
#include "memcheck_passes.h"

#include "complain.h"
#include "folder.h"
#include "memcheck_findings.h"
#include "path.h"
#include "progress.h"
#include "run_end.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// Its log ends after a thousand messages by itself.
enum { MAX_LOG_BYTES = 8 << 20 };

// Seconds of processor time of a pass: some times what the slowest solution needs.
enum { PASS_SECONDS = 15 };

// How often is looked whether something was found.
static const struct timespec pause_between_looks = {.tv_nsec = 200 * 1000 * 1000};

// Races and values never set are looked for apart: together Oclgrind is slower than both. Indices
// out of range are found in either.
typedef struct Pass {
    const char *log;    // its file, in a folder of its own
    const char *looks;  // what it is to look for
} Pass;
static const Pass passes[] = {
    {"races", "OCLGRIND_DATA_RACES=1"},
    {"unset", "OCLGRIND_UNINITIALIZED=1"},
};
enum { N_PASSES = sizeof passes / sizeof *passes };

// The folder that a pass writes its log to.
static void out_path(const Memcheck *memcheck, const Variant *variant, const Pass *pass,
                     char path[PATH_MAX])
{
    path_make(path, "%s/variant-%s/out-%s", memcheck->session.workshop.folder, variant->name,
              pass->log);
}

// Start a variant's probe with Oclgrind for its driver. NULL after one message.
static SandboxRun *start_pass(const Memcheck *memcheck, const Variant *variant, const Pass *pass,
                              SandboxTime time)
{
    const Workshop *workshop = &memcheck->session.workshop;
    const char *lab = memcheck->session.manifest.lab, *name = variant->name;
    char tree[PATH_MAX], files[PATH_MAX], build[PATH_MAX], out[PATH_MAX], job[PATH_MAX],
        inside[PATH_MAX], probe[PATH_MAX];
    path_make(files, "%s/variant-%s/lab", workshop->folder, name);
    path_make(tree, "%s/tree", workshop->folder);
    path_make(build, "%s/variant-%s/build", workshop->folder, name);
    out_path(memcheck, variant, pass, out);
    if ((folder_remove(out) != 0 && errno != ENOENT) || mkdir(out, 0755) != 0 ||
        chmod(out, 0755) != 0) {
        complain("memcheck: %s: cannot be made: %s", out, strerror(errno));
        return NULL;
    }
    path_make(job, "%s/job", workshop->folder);
    path_make(inside, "/work/labs/%s", lab);
    path_make(probe, "lib/%s", lab);
    const char *const argv[] = {workshop->needs_compiler ? "build/probe" : probe, NULL};
    char log[PATH_MAX];
    path_make(log, "OCLGRIND_LOG=out/%s", pass->log);
    // Not optimised: Oclgrind 21.10 crashes where values are unset and optimised code shuffles
    // float3, and knows nothing of the marks that the optimiser leaves where it puts one function
    // into another (llvm.experimental.noalias.scope.decl).
    const char *const environment[] = {"OCL_ICD_VENDORS=" OCLGRIND_DRIVER, log, pass->looks,
                                       "OCLGRIND_BUILD_OPTIONS=-cl-opt-disable", NULL};
    const SandboxCommand command = {
        .kind = workshop->sandbox,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{tree, "/work", 0},
                   {files, inside, 0},
                   {build, "/work/build", 0},
                   {out, "/work/out", 1},
                   {job, "/work/job", 0}},
        .n_mounts = 5,
        .time = time,
        .memory_mb = MEMORY_MB,
        .file_mb = FILE_MB,
        .n_processes = N_PROCESSES,
    };
    return sandbox_start(&command);
}

// The log of a pass; NULL when there is none that one may read. A link or a pipe in its place, left
// by what ran inside, is neither followed nor waited for.
static char *log_load(const Memcheck *memcheck, const Pass *pass)
{
    char folder[PATH_MAX], path[PATH_MAX];
    out_path(memcheck, &memcheck->whole, pass, folder);
    path_make(path, "%s/%s", folder, pass->log);
    const int descriptor = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    struct stat status;
    if (descriptor < 0 || fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        if (descriptor >= 0) {
            close(descriptor);
        }
        return NULL;
    }
    FILE *file = fdopen(descriptor, "r");
    char *log = calloc(1, MAX_LOG_BYTES + 1);
    if (file == NULL || log == NULL || fread(log, 1, MAX_LOG_BYTES, file) == 0) {
        free(log);
        log = NULL;
    }
    if (file != NULL) {
        fclose(file);
    }
    return log;
}

// Read what the passes have found up to now.
static void findings_read(Memcheck *memcheck)
{
    memcheck->n_findings = 0;
    for (int i = 0; i < N_PASSES; i++) {
        char *log = log_load(memcheck, &passes[i]);
        if (log != NULL) {
            memcheck->n_findings = oclgrind_log_read(log, memcheck->findings, memcheck->n_findings);
        }
        free(log);
    }
}

// Where a pass was, as its probe noted it: its inputs are others than the judge's.
static void print_place(Memcheck *memcheck, const Pass *pass)
{
    char folder[PATH_MAX];
    out_path(memcheck, &memcheck->whole, pass, folder);
    const ProbeNote note = run_note_load(folder);
    RunPlace place = run_place_before(&note);
    if (place.where[0] == '\0') {
        place = judge_place(&memcheck->session.judge, &note);
    }
    printf(place.where[0] != '\0' ? "where: %s\n" : "", place.where);
}

// Say how a pass that did not come to its end ended. Once is enough: the other pass mostly ends in
// the same way.
static void print_trouble(Memcheck *memcheck, const Pass *pass, const SandboxResult *result,
                          SandboxTime allowed)
{
    if (!memcheck->has_trouble) {
        char *end = run_end_describe(result, allowed);
        printf("It did not run to its end under Oclgrind: %s\n", end);
        print_place(memcheck, pass);
        if (result->outcome == SANDBOX_TIMED_OUT) {
            printf("\"make grade\" tells whether it is an endless loop. On a slow machine "
                   "TIME_LIMIT=100 gives it more time.\n");
        }
        printf("%s", result->output);
        free(end);
    }
    memcheck->has_trouble = 1;
}

// A folder that not everybody may read is opened to one run at a time; all passes read these.
static int folders_open(const Memcheck *memcheck, const Variant *variant)
{
    static const char *const folders[] = {"lab", "build"};
    char path[PATH_MAX];
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        path_make(path, "%s/variant-%s/%s", memcheck->session.workshop.folder, variant->name,
                  folders[i]);
        if (chmod(path, 0755) != 0) {
            complain("memcheck: %s: cannot be opened: %s", path, strerror(errno));
            return -1;
        }
    }
    return 0;
}

// Tell a finding at once. If something went wrong in a given file before it, that comes first: it
// is nearer to the mistake.
static void tell(Memcheck *memcheck, const Finding *finding)
{
    if (finding != memcheck->findings) {
        finding_print(memcheck, memcheck->findings);
        memcheck->n_told++;
    }
    finding_print(memcheck, finding);
    memcheck->n_told++;
    fflush(stdout);
}

// Wait until the passes have ended, or something is found in one of the student's files: tell it
// and end them. It may be half written at the first look, so it is told at the next.
static void passes_watch(Memcheck *memcheck, SandboxRun *const runs[N_PASSES])
{
    for (int was_seen = 0, n_running = N_PASSES; n_running > 0;) {
        n_running = 0;
        for (int i = 0; i < N_PASSES; i++) {
            n_running += !sandbox_has_ended(runs[i]);
        }
        findings_read(memcheck);
        const Finding *first = finding_first_own(memcheck);
        if (first != NULL && (was_seen || n_running == 0)) {
            progress_hide();
            tell(memcheck, first);
            for (int i = 0; i < N_PASSES; i++) {
                sandbox_allow(runs[i], (SandboxTime){0});
            }
            return;
        }
        was_seen = first != NULL;
        progress_show();
        nanosleep(&pause_between_looks, NULL);
    }
    progress_hide();
}

// Run the passes side by side. Returns 0, or -1 after one message when the machinery failed.
static int passes_run(Memcheck *memcheck, SandboxTime time, SandboxResult results[N_PASSES])
{
    SandboxRun *runs[N_PASSES];
    int failed = 0;
    if (folders_open(memcheck, &memcheck->whole) != 0) {
        return -1;
    }
    for (int i = 0; i < N_PASSES; i++) {
        runs[i] = start_pass(memcheck, &memcheck->whole, &passes[i], time);
        failed |= runs[i] == NULL;
    }
    if (!failed) {
        passes_watch(memcheck, runs);
    }
    for (int i = 0; i < N_PASSES; i++) {
        results[i] =
            runs[i] != NULL ? sandbox_wait(runs[i]) : (SandboxResult){.outcome = SANDBOX_FAULT};
        if (results[i].outcome == SANDBOX_STARVED) {
            complain("memcheck: this machine is too busy: try again when it is less so");
        } else if (results[i].outcome == SANDBOX_FAULT && runs[i] != NULL) {
            complain("memcheck: the sandbox failed: %s", results[i].output);
        }
        failed |= results[i].outcome == SANDBOX_FAULT || results[i].outcome == SANDBOX_STARVED;
    }
    return failed ? -1 : 0;
}

int memcheck_passes(Memcheck *memcheck)
{
    const int given = memcheck->session.settings->time_limit;
    const Allowance allowance = {.given_seconds = given > 0 ? given : PASS_SECONDS};
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 0);
    SandboxResult results[N_PASSES] = {0};
    printf("Oclgrind runs the kernels twice on a small job, for races and for values never set:\n"
           "%.0f s of processor time each at most.\n",
           time.processor);
    fflush(stdout);
    progress_say("running the kernels under Oclgrind");
    const int failed = passes_run(memcheck, time, results);
    for (int i = 0; i < N_PASSES && failed == 0 && memcheck->n_told == 0; i++) {
        if (results[i].outcome != SANDBOX_EXITED || results[i].exit_status != 0) {
            print_trouble(memcheck, &passes[i], &results[i], time);
        }
    }
    if (failed == 0 && memcheck->n_told == 0 && memcheck->n_findings > 0) {
        tell(memcheck, &memcheck->findings[0]);
    }
    for (int i = 0; i < N_PASSES; i++) {
        free(results[i].output);
    }
    return failed;
}
