// Oclgrind's passes over a submission's probe (see memcheck_passes.h).
#include "memcheck_passes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_BYTES = MEMCHECK_PATH_BYTES };

// Its log ends after a thousand messages by itself.
enum { MAX_LOG_BYTES = 8 << 20, MEMORY_MB = 4096, FILE_MB = 64, N_PROCESSES = 512 };

// Races and values never set are looked for apart: together Oclgrind is slower than both. Indices
// out of range are found in either.
typedef struct Pass {
    const char *log;     // its file, in a folder of its own
    const char *looks;   // what it is to look for
    const char *option;  // one more NAME=value, or NULL
} Pass;
static const Pass passes[] = {
    {"races", "OCLGRIND_DATA_RACES=1", NULL},
    // Oclgrind 21.10 itself crashes in this pass where optimised code shuffles float3.
    {"unset", "OCLGRIND_UNINITIALIZED=1", "OCLGRIND_BUILD_OPTIONS=-cl-opt-disable"},
};
enum { N_PASSES = sizeof passes / sizeof *passes };

// Start the probe with Oclgrind for its driver. NULL after one message.
static SandboxRun *start_pass(const Memcheck *memcheck, const Pass *pass)
{
    const Workshop *workshop = &memcheck->session.workshop;
    const char *lab = memcheck->session.manifest.lab, *name = memcheck->whole.name;
    char tree[PATH_BYTES], build[PATH_BYTES], out[PATH_BYTES], job[PATH_BYTES], inside[PATH_BYTES],
        probe[PATH_BYTES];
    snprintf(tree, sizeof tree, "%s/tree", workshop->folder);
    snprintf(build, sizeof build, "%s/variant-%s/build", workshop->folder, name);
    snprintf(out, sizeof out, "%s/variant-%s/out-%s", workshop->folder, name, pass->log);
    if (mkdir(out, 0755) != 0 || chmod(out, 0755) != 0) {
        fprintf(stderr, "memcheck: %s: cannot be made: %s\n", out, strerror(errno));
        return NULL;
    }
    snprintf(job, sizeof job, "%s/job", workshop->folder);
    snprintf(inside, sizeof inside, "/work/labs/%s", lab);
    snprintf(probe, sizeof probe, "lib/%s", lab);
    const char *const argv[] = {workshop->needs_compiler ? "build/probe" : probe, NULL};
    char log[PATH_BYTES];
    snprintf(log, sizeof log, "OCLGRIND_LOG=out/%s", pass->log);
    const char *const environment[] = {"OCL_ICD_VENDORS=" OCLGRIND_DRIVER, log, pass->looks,
                                       pass->option, NULL};
    const SandboxCommand command = {
        .kind = workshop->sandbox,
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{tree, "/work", 0},
                   {memcheck->folder, inside, 0},
                   {build, "/work/build", 0},
                   {out, "/work/out", 1},
                   {job, "/work/job", 0}},
        .n_mounts = 5,
        .wall_seconds = memcheck->session.settings->time_limit,
        .cpu_seconds = 2 * memcheck->session.settings->time_limit,
        .memory_mb = MEMORY_MB,
        .file_mb = FILE_MB,
        .n_processes = N_PROCESSES,
    };
    return sandbox_start(&command);
}

// The log of a pass; NULL when there is none that one may read. A link or a pipe in its place, left
// by what ran inside, is neither followed nor waited for.
static char *log_load(const Memcheck *memcheck, const char *pass)
{
    char path[PATH_BYTES];
    snprintf(path, sizeof path, "%s/variant-%s/out-%s/%s", memcheck->session.workshop.folder,
             memcheck->whole.name, pass, pass);
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
static void take_log(Memcheck *memcheck, const char *pass)
{
    char *log = log_load(memcheck, pass);
    if (log != NULL) {
        memcheck->n_findings = oclgrind_log_read(log, memcheck->findings, memcheck->n_findings);
    }
    free(log);
}

// Take in how a pass ended. Returns 0, or -1 after one message when the machinery failed.
static int take_pass(Memcheck *memcheck, SandboxRun *run, const char *pass)
{
    SandboxResult result = sandbox_wait(run);
    if (result.outcome == SANDBOX_FAULT) {
        fprintf(stderr, "memcheck: the sandbox failed: %s\n", result.output);
        free(result.output);
        return -1;
    }
    take_log(memcheck, pass);
    if (result.outcome != SANDBOX_EXITED || result.exit_status != 0) {
        // One is enough: the other pass mostly ends in the same way.
        if (!memcheck->has_trouble) {
            printf("It did not run to its end under Oclgrind (%s).\n%s",
                   result.outcome == SANDBOX_TIMED_OUT ? "out of time: an endless loop?"
                   : result.outcome == SANDBOX_CRASHED ? strsignal(result.signal)
                                                       : "it ended early",
                   result.output);
        }
        memcheck->has_trouble = 1;
    }
    free(result.output);
    return 0;
}

int memcheck_passes(Memcheck *memcheck)
{
    SandboxRun *runs[N_PASSES];
    int result = 0;
    for (int i = 0; i < N_PASSES; i++) {
        runs[i] = start_pass(memcheck, &passes[i]);
        result |= runs[i] == NULL ? -1 : 0;
    }
    for (int i = 0; i < N_PASSES; i++) {
        result |= runs[i] != NULL ? take_pass(memcheck, runs[i], passes[i].log) : 0;
    }
    return result;
}
