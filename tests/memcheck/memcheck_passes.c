// Oclgrind's passes over a submission's probe (see memcheck_passes.h).
#include "memcheck_passes.h"

#include "complain.h"
#include "folder.h"
#include "path.h"
#include "run_end.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Its log ends after a thousand messages by itself.
enum { MAX_LOG_BYTES = 8 << 20 };

// Seconds that are enough for a pass over a solution on most machines, and where there is no
// solution to ask, on all.
enum { SHORT_SECONDS = 20, LONG_SECONDS = 100 };

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

// Add a pass's findings to the others.
static void take_log(Memcheck *memcheck, const Pass *pass)
{
    char *log = log_load(memcheck, pass);
    if (log != NULL) {
        memcheck->n_findings = oclgrind_log_read(log, memcheck->findings, memcheck->n_findings);
    }
    free(log);
}

// Say how a pass that did not come to its end ended. Once is enough: the other pass mostly ends in
// the same way.
static void print_trouble(Memcheck *memcheck, const SandboxResult *result, SandboxTime allowed)
{
    if (!memcheck->has_trouble) {
        char *end = run_end_describe(result, allowed);
        printf("It did not run to its end under Oclgrind: %s\n%s", end, result->output);
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

// Run a variant's passes side by side. Returns 0, or -1 after one message when the machinery
// failed.
static int passes_run(const Memcheck *memcheck, const Variant *variant, SandboxTime time,
                      SandboxResult results[N_PASSES])
{
    SandboxRun *runs[N_PASSES];
    int failed = 0;
    if (folders_open(memcheck, variant) != 0) {
        return -1;
    }
    for (int i = 0; i < N_PASSES; i++) {
        runs[i] = start_pass(memcheck, variant, &passes[i], time);
        failed |= runs[i] == NULL;
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

static void results_free(SandboxResult results[N_PASSES])
{
    for (int i = 0; i < N_PASSES; i++) {
        free(results[i].output);
        results[i].output = NULL;
    }
}

// What a pass may use where the short time was not enough: what our solution's slower pass does,
// times a factor. Returns 0, or -1 after one message when the machinery failed.
static int ask_solution(Memcheck *memcheck, SandboxTime *time)
{
    Session *session = &memcheck->session;
    Variant *solution[] = {&session->solution};
    SandboxResult results[N_PASSES] = {0};
    Allowance allowance = {0};
    if (session->workshop.needs_compiler && session_run(session, solution, 1) != 0) {
        return -1;
    }
    const int failed = passes_run(memcheck, &session->solution, allowance_ours(), results);
    for (int i = 0; i < N_PASSES; i++) {
        const SandboxTime used = results[i].used;
        if (!allowance.is_known[STEP_RUNNING] ||
            used.processor > allowance.solution[STEP_RUNNING].processor) {
            allowance_note(&allowance, STEP_RUNNING, used);
        }
    }
    *time = allowance_of(&allowance, STEP_RUNNING, 1);
    results_free(results);
    return failed;
}

// Did one of the passes run out of processor time?
static int has_timed_out(const SandboxResult results[N_PASSES])
{
    int has = 0;
    for (int i = 0; i < N_PASSES; i++) {
        has |= results[i].outcome == SANDBOX_TIMED_OUT;
    }
    return has;
}

// Tell at once what may take a while.
static void say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    fflush(stdout);
}

int memcheck_passes(Memcheck *memcheck)
{
    const int given = memcheck->session.settings->time_limit;
    const int can_ask = memcheck->session.has_solution && given == 0;
    Allowance first = {.given_seconds = given > 0 ? given : can_ask ? SHORT_SECONDS : LONG_SECONDS};
    SandboxTime time = allowance_of(&first, STEP_RUNNING, 1);
    SandboxResult results[N_PASSES] = {0};
    say("Oclgrind runs the kernels twice on a small job, for races and for values never set:\n"
        "%.0f s of processor time each at most.\n",
        time.processor);
    int failed = passes_run(memcheck, &memcheck->whole, time, results);
    if (failed == 0 && can_ask && has_timed_out(results)) {
        SandboxTime more = time;
        say("That was not enough. How much does the solution take? This may last minutes.\n");
        failed = ask_solution(memcheck, &more);
        if (failed == 0 && more.processor > time.processor) {
            time = more;
            results_free(results);
            failed = passes_run(memcheck, &memcheck->whole, time, results);
        }
    }
    for (int i = 0; i < N_PASSES && failed == 0; i++) {
        take_log(memcheck, &passes[i]);
        if (results[i].outcome != SANDBOX_EXITED || results[i].exit_status != 0) {
            print_trouble(memcheck, &results[i], time);
        }
    }
    results_free(results);
    return failed;
}
