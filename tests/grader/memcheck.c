// memcheck: run a submission's kernels under Oclgrind, which sees what a device passes over in
// silence: indices out of range, values that were never set, races, barriers that not all reach.
//
//     memcheck --lab 03 [--submission FOLDER]
//
// The lab's probe does a small job (memcheck_job.h) in the sandbox, with Oclgrind as its OpenCL
// driver; what Oclgrind writes down is told at the student's own lines. It is a diagnosis and earns
// or costs no points. Exit status: 0 nothing found, 1 something, 2 it could not be tried.
#include "memcheck_job.h"
#include "message.h"
#include "oclgrind_log.h"
#include "session.h"
#include "settings.h"
#include "stage.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_CLEAN = 0, EXIT_FOUND = 1, EXIT_FAULT = 2, PATH_BYTES = 600 };

// Oclgrind as a driver that the OpenCL loader can be told of.
#define OCLGRIND_DRIVER "/usr/lib/oclgrind/liboclgrind-rt-icd.so"

// Its log ends after a thousand messages by itself.
enum { MAX_LOG_BYTES = 8 << 20, MEMORY_MB = 4096, FILE_MB = 64, N_PROCESSES = 512 };

// Races and values never set are looked for apart: together Oclgrind is slower than both. Indices
// out of range are found in either.
typedef struct Pass {
    const char *log;     // its file in out/
    const char *looks;   // what it is to look for
    const char *option;  // one more NAME=value, or NULL
} Pass;
static const Pass passes[] = {
    {"races", "OCLGRIND_DATA_RACES=1", NULL},
    // Oclgrind 21.10 itself crashes in this pass where optimised code shuffles float3.
    {"unset", "OCLGRIND_UNINITIALIZED=1", "OCLGRIND_BUILD_OPTIONS=-cl-opt-disable"},
};
enum { N_PASSES = sizeof passes / sizeof *passes };

// One submission under Oclgrind.
typedef struct Memcheck {
    Session session;
    Variant whole;
    char folder[PATH_BYTES];  // of the submission's files
    int has_trouble;          // it did not run to its end
    Finding findings[MAX_FINDINGS];
    int n_findings;
} Memcheck;

// ---- Running ----------------------------------------------------------------------------------

// Replace the judge's job by a small one. Returns 0, or -1 after one message.
static int shrink_job(const Session *session)
{
    char path[PATH_BYTES];
    Sections job;
    workshop_job_path(&session->workshop, path, sizeof path);
    if (sections_load(path, (size_t)256 << 20, &job) != 0) {
        fprintf(stderr, "memcheck: %s: the job cannot be read\n", path);
        return -1;
    }
    FILE *file = fopen(path, "wb");
    int result = file ? memcheck_job_write(&job, file) : -1;
    if (file == NULL || fclose(file) != 0) {
        fprintf(stderr, "memcheck: %s: cannot be written: %s\n", path, strerror(errno));
        result = -1;
    }
    sections_free(&job);
    return result;
}

// Start the probe with Oclgrind for its driver. NULL after one message.
static SandboxRun *start_pass(const Memcheck *memcheck, const Pass *pass)
{
    const Workshop *workshop = &memcheck->session.workshop;
    const char *lab = memcheck->session.manifest.lab, *name = memcheck->whole.name;
    char tree[PATH_BYTES], build[PATH_BYTES], out[PATH_BYTES], job[PATH_BYTES], inside[PATH_BYTES],
        probe[PATH_BYTES];
    snprintf(tree, sizeof tree, "%s/tree", workshop->folder);
    snprintf(build, sizeof build, "%s/variant-%s/build", workshop->folder, name);
    snprintf(out, sizeof out, "%s/variant-%s/out", workshop->folder, name);
    snprintf(job, sizeof job, "%s/job", workshop->folder);
    snprintf(inside, sizeof inside, "/work/labs/%s", lab);
    snprintf(probe, sizeof probe, "/work/lib/%s", lab);
    const char *const argv[] = {workshop->needs_compiler ? "/work/build/probe" : probe, NULL};
    char log[PATH_BYTES];
    snprintf(log, sizeof log, "OCLGRIND_LOG=/work/out/%s", pass->log);
    const char *const environment[] = {"OCL_ICD_VENDORS=" OCLGRIND_DRIVER, log, pass->looks,
                                       pass->option, NULL};
    const SandboxCommand command = {
        .argv = argv,
        .environment = environment,
        .folder = "/work",
        .mounts = {{tree, "/work", 0},
                   {memcheck->folder, inside, 0},
                   {build, "/work/build", 0},
                   {out, "/work/out", 1},
                   {job, "/work/job", 0}},
        .n_mounts = 5,
        .wall_seconds = memcheck->session.settings.time_limit,
        .cpu_seconds = 2 * memcheck->session.settings.time_limit,
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
    snprintf(path, sizeof path, "%s/variant-%s/out/%s", memcheck->session.workshop.folder,
             memcheck->whole.name, pass);
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
    Finding findings[MAX_FINDINGS];
    char *log = log_load(memcheck, pass);
    const int n = log ? oclgrind_log_read(log, findings) : 0;
    for (int i = 0; i < n; i++) {
        int is_known = 0;
        for (int j = 0; j < memcheck->n_findings; j++) {
            const Finding *known = &memcheck->findings[j];
            is_known |= known->says == findings[i].says && known->line == findings[i].line &&
                        strcmp(known->file, findings[i].file) == 0;
        }
        if (!is_known && memcheck->n_findings < MAX_FINDINGS) {
            memcheck->findings[memcheck->n_findings++] = findings[i];
        }
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

static int run_passes(Memcheck *memcheck)
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

// ---- Telling ----------------------------------------------------------------------------------

// Is it one of the files a student hands in? Then *name is its name without a folder.
static int is_own_file(const Memcheck *memcheck, const char *path, const char **name)
{
    const char *slash = strrchr(path, '/');
    *name = slash ? slash + 1 : path;
    for (int i = 0; i < memcheck->session.manifest.n_files; i++) {
        if (strcmp(memcheck->session.manifest.files[i], *name) == 0) {
            return 1;
        }
    }
    return 0;
}

// Print a line of one of the student's files, without its indentation.
static void source_print(const Memcheck *memcheck, const char *name, int line)
{
    char path[2 * PATH_BYTES], text[512];
    snprintf(path, sizeof path, "%s/%s", memcheck->folder, name);
    FILE *file = fopen(path, "r");
    for (int at = 0; file != NULL && at < line && fgets(text, sizeof text, file) != NULL;) {
        const size_t length = strlen(text);
        at += length > 0 && text[length - 1] == '\n';
        if (at == line) {
            printf("        %s", text + strspn(text, " \t"));
        }
    }
    if (file != NULL) {
        fclose(file);
    }
}

static void finding_print(const Memcheck *memcheck, const Finding *finding)
{
    const char *name, *other;
    if (is_own_file(memcheck, finding->file, &name)) {
        printf("%s:%d: %s\n", name, finding->line, finding->says);
        source_print(memcheck, name, finding->line);
    } else {
        printf("%s, line %d, given, with what it got from yours: %s\n", name, finding->line,
               finding->says);
    }
    if (finding->other_file[0] != '\0' && is_own_file(memcheck, finding->other_file, &other)) {
        printf("    the other one is at %s:%d\n", other, finding->other_line);
    }
    printf("    %d time%s%s%s\n", finding->n_times, finding->n_times == 1 ? "" : "s",
           finding->work_item[0] ? ", first in work-item " : "", finding->work_item);
}

// Print what was found. What goes wrong in a given file mostly follows from what goes wrong in the
// student's, so it is told only where nothing else is.
static void findings_print(const Memcheck *memcheck)
{
    const char *name;
    int n_own = 0;
    for (int i = 0; i < memcheck->n_findings; i++) {
        n_own += is_own_file(memcheck, memcheck->findings[i].file, &name);
    }
    for (int i = 0; i < memcheck->n_findings; i++) {
        if (n_own == 0 || is_own_file(memcheck, memcheck->findings[i].file, &name)) {
            finding_print(memcheck, &memcheck->findings[i]);
        }
    }
    if (memcheck->n_findings > 0) {
        printf("Begin with the first: others may follow from it. Oclgrind errs now and then; no "
               "points "
               "depend on it.\n");
    } else if (!memcheck->has_trouble) {
        printf("%s: Oclgrind found nothing on a small job.\n", memcheck->session.manifest.lab);
    }
}

// ---- All --------------------------------------------------------------------------------------

// Returns an exit status.
static int memcheck_run(Memcheck *memcheck, const Settings *settings)
{
    Session *session = &memcheck->session;
    const SessionSettings session_settings = {settings->lab, settings->build, "", settings->seed,
                                              settings->time_limit};
    char *staging = NULL;
    if (session_open(session, session_settings) != 0 || shrink_job(session) != 0 ||
        variant_open(&session->workshop, "whole", &memcheck->whole, memcheck->folder,
                     sizeof memcheck->folder) != 0) {
        return EXIT_FAULT;
    }
    const int staged =
        stage_submission(&session->manifest, settings->submission, memcheck->folder, &staging);
    if (staged != 0) {
        fprintf(stderr, "%s\n", staging ? staging : "memcheck: nothing to look at");
        free(staging);
        return EXIT_FAULT;
    }
    free(staging);
    // Host files are compiled on the way.
    Variant *variants[] = {&memcheck->whole};
    if (session->workshop.needs_compiler && session_run(session, variants, 1) != 0) {
        return EXIT_FAULT;
    }
    if (memcheck->whole.build_log != NULL) {
        printf("It does not compile:\n%s\n", memcheck->whole.build_log);
        return EXIT_FAULT;
    }
    if (run_passes(memcheck) != 0) {
        return EXIT_FAULT;
    }
    findings_print(memcheck);
    return memcheck->n_findings > 0 || memcheck->has_trouble ? EXIT_FOUND : EXIT_CLEAN;
}

// Has the lab a kernel that a student writes?
static int has_kernels(const char *lab)
{
    Manifest manifest;
    int has = 0;
    if (manifest_load("labs", lab, &manifest) != 0) {
        return 0;
    }
    for (int i = 0; i < manifest.n_files; i++) {
        has |= strstr(manifest.files[i], ".cl") != NULL;
    }
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
        fprintf(stderr,
                "memcheck: %s: found no kernel to hand in, expected one: Oclgrind looks at "
                "kernels only\n",
                settings.lab);
        return EXIT_FAULT;
    }
    if (access(OCLGRIND_DRIVER, R_OK) != 0) {
        fprintf(stderr, "memcheck: found no Oclgrind (" OCLGRIND_DRIVER "); install the package "
                        "oclgrind, which Debian 12 has and Debian 13 has not\n");
        return EXIT_FAULT;
    }
    static Memcheck memcheck;
    const int status = memcheck_run(&memcheck, &settings);
    variant_free(&memcheck.whole);
    if (!getenv("KEEP")) {
        session_close(&memcheck.session);
    }
    return status;
}
