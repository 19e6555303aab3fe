// The sanitizers' passes over a submission's probe (see memcheck_passes.h).
#include "memcheck_passes.h"

#include "clean_text.h"
#include "complain.h"
#include "crash_line.h"
#include "folder.h"
#include "memcheck_findings.h"
#include "path.h"
#include "probe.h"
#include "progress.h"
#include "run_end.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#define MAX_ANSWER_BYTES ((size_t)FILE_MB << 20)

enum { MAX_WORDS = 8 + MANIFEST_MAX_FILES };

// Seconds of processor time of a pass: some times what the slowest solution needs.
enum { PASS_SECONDS = 15 };

// What sanitized.c writes, and how the sanitizers' files begin.
#define PLACE "fault"
#define REPORT "report."

// Frames get their lines from addr2line, which whoever has gcc has.
#define COMMON_OPTIONS                                                                             \
    "log_path=out/report:color=never:handle_abort=1:handle_sigfpe=1:handle_sigill=1:"              \
    "handle_sigbus=1:allocator_may_return_null=1:allow_addr2line=1:"                               \
    "external_symbolizer_path=/usr/bin/addr2line:fast_unwind_on_fatal=1"

// What both passes compile kernels with: not optimised, as a read whose value nobody needs is a
// fault, too, and a value that was never set would be whatever makes the code short.
// Work-items run one after the other, so each may as well have a `local` variable of its own.
#define KERNELS                                                                                    \
    "NATIVE_OPTIONS=-Dlocal= -D__local= -include lib/checked.h -g -O0 -fno-omit-frame-pointer "

// One sanitizer.
typedef struct Pass {
    const char *sanitizer;  // clang's name of it, and its library's
    const char *job;        // PROBE_JOB_VARIABLE
    const char *host;       // how host files are compiled
    const char *environment[6];
} Pass;
static const Pass passes[] = {
    {"address",
     "",
     "-fsanitize=address,undefined -fno-sanitize-recover=all",
     {KERNELS "-fsanitize=address,bounds,integer-divide-by-zero -fno-sanitize-recover=all",
      "ASAN_OPTIONS=detect_leaks=0:detect_stack_use_after_return=0:" COMMON_OPTIONS,
      "UBSAN_OPTIONS=print_stacktrace=1:" COMMON_OPTIONS}},
    // It knows nothing of what is stored by code that is not compiled for it: only the bytes of
    // memory objects and kernels' variables count as never set.
    {"memory",
     MEMCHECK_SMALL_JOB,
     "",
     {KERNELS "-fsanitize=memory -fsanitize-memory-track-origins -mllvm -msan-eager-checks=0",
      "MSAN_OPTIONS=poison_in_malloc=0:poison_in_free=0:" COMMON_OPTIONS}},
};
enum { N_PASSES = sizeof passes / sizeof *passes };

// The script's exit status where a host file does not compile, or does not link.
enum { EXIT_NO_HOST = 3 };

// What is printed before any of the student's code runs, by this script or by sanitized.c: from
// then on exit statuses are the student's own.
#define BEGINS "[from here on your "

// Compile host files, link the probe with OpenCL of our own, and run it, all in the sandbox.
static const char script[] =
    "sanitizer=$1 lab=$2 host=$3\n"
    "shift 3\n"
    "for folder in solutions/*; do host=\"$host -I $folder\"; done\n"
    "for file do\n"
    "    clang -std=c11 -D_GNU_SOURCE -O1 -g -fno-omit-frame-pointer -w -Icommon -Ikernels \\\n"
    "        -I \"labs/$lab\" -include lib/checked.h $host -c \"labs/$lab/$file\" -o "
    "\"build/$file.o\" || exit 3\n"
    "    set -- \"$@\" \"build/$file.o\" && shift\n"
    "done\n"
    "clang -fsanitize=\"$sanitizer\" \"lib/$lab.o\" \"$@\" \"lib/earlier/$lab.a\" lib/libcommon.a "
    "\\\n"
    "    \"lib/memcheck-$sanitizer.so\" -lm -o build/memcheck || exit 3\n"
    "[ $# -eq 0 ] || echo '" BEGINS "C code runs]'\n"
    "exec build/memcheck\n";

// ---- Starting ----------------------------------------------------------------------------------

// A folder of a pass's own: "build" or "out".
static void folder_path(const Memcheck *memcheck, const Pass *pass, const char *name,
                        char path[PATH_MAX])
{
    path_make(path, "%s/%s-%s", memcheck->whole.folder, name, pass->sanitizer);
}

// Make it, empty. Returns 0, or -1 after one message.
static int folder_new(const char *path)
{
    if ((folder_remove(path) != 0 && errno != ENOENT) || mkdir(path, 0755) != 0) {
        complain("memcheck: %s: cannot be made: %s", path, strerror(errno));
        return -1;
    }
    return 0;
}

// Start a pass. NULL after one message.
static SandboxRun *start_pass(const Memcheck *memcheck, const Pass *pass, SandboxTime time)
{
    const Workdir *workdir = &memcheck->session.workdir;
    const Manifest *manifest = &memcheck->session.manifest;
    char lab[PATH_MAX], build[PATH_MAX], out[PATH_MAX], job[PATH_MAX], inside[PATH_MAX],
        variable[64];
    path_make(lab, "%s/lab", memcheck->whole.folder);
    folder_path(memcheck, pass, "build", build);
    folder_path(memcheck, pass, "out", out);
    if (folder_new(build) != 0 || folder_new(out) != 0) {
        return NULL;
    }
    path_make(job, "%s/job", workdir->folder);
    path_make(inside, "/work/labs/%s", manifest->lab);
    snprintf(variable, sizeof variable, PROBE_JOB_VARIABLE "=%s", pass->job);
    const char *environment[8] = {variable};
    memcpy(environment + 1, pass->environment, sizeof pass->environment);
    const char *argv[MAX_WORDS] = {"/bin/sh",       "-c",          script,    "memcheck",
                                   pass->sanitizer, manifest->lab, pass->host};
    int n = 7;
    for (int i = 0; i < manifest->n_files; i++) {
        if (manifest_is_host_file(manifest->files[i])) {
            argv[n++] = manifest->files[i];
        }
    }
    SandboxCommand command = workdir_command(workdir, argv, environment, time);
    const SandboxMount mounts[] = {
        {lab, inside, 0}, {build, "/work/build", 1}, {out, "/work/out", 1}, {job, "/work/job", 0}};
    memcpy(command.mounts + 1, mounts, sizeof mounts);
    command.n_mounts = 5;
    command.memory_mb = 0;  // sanitizers reserve terabytes that they never use
    return sandbox_start(&command);
}

// ---- What it left -------------------------------------------------------------------------------

// Tell what a pass has found, if it has.
static void tell_finding(Memcheck *memcheck, const char *out)
{
    char path[PATH_MAX];
    Finding finding;
    path_make(path, "%s/" PLACE, out);
    char *report = report_find(out, REPORT);
    char *place = report_load(path);
    if (report != NULL &&
        finding_read(report, place != NULL ? place : "", &memcheck->session.manifest, &finding)) {
        // Of a function that is called for itself, a work-item is only the number of an input.
        const ProbeNote note = run_note_load(out);
        if (strcmp(note.name, "picture") != 0) {
            finding.work_item[0] = '\0';
        }
        memcheck->has_finding = finding_print(memcheck, &finding);
    }
    free(report);
    free(place);
}

// Where a pass was, as its probe noted it: its inputs are others than the judge's.
static void print_place(Memcheck *memcheck, const char *out)
{
    const ProbeNote note = run_note_load(out);
    RunPlace place = run_place_before(&note);
    if (place.where[0] == '\0') {
        place = judge_place(&memcheck->session.judge, &note);
    }
    printf(place.where[0] != '\0' ? "where: %s\n" : "", place.where);
}

// What a pass has printed, which may be anything; of our own lines not those before all else.
static void print_output(const char *output)
{
    while (strncmp(output, BEGINS, strlen(BEGINS)) == 0) {
        output += strcspn(output, "\n");
        output += output[0] == '\n';
    }
    char *clean = message_clean(output);
    printf(clean[0] != '\0' ? "%s\n" : "", clean);
    free(clean);
}

// Say how a pass ended that did not come to its end.
//   end   in words
static void tell_trouble(Memcheck *memcheck, const char *out, const SandboxResult *result,
                         const char *end)
{
    const int has_exited = result->outcome == SANDBOX_EXITED;
    const int is_no_build = has_exited && result->exit_status == PROBE_EXIT_NO_BUILD;
    const int is_no_host = has_exited && result->exit_status == EXIT_NO_HOST;
    memcheck->has_trouble = 1;
    if ((is_no_build || is_no_host) && strstr(result->output, BEGINS) == NULL) {
        printf("It does not compile:\n");
    } else {
        printf("It did not run to its end: %s\n",
               is_no_build ? "it ended as it does when a kernel cannot be built" : end);
        print_place(memcheck, out);
    }
    if (result->outcome == SANDBOX_TIMED_OUT) {
        printf("\"make grade\" tells whether it is an endless loop. TIME_LIMIT=100 gives it more "
               "time.\n");
    }
    print_output(result->output);
}

// Tell what came of a pass, unless it came to its end without a finding.
static void tell(Memcheck *memcheck, const Pass *pass, const SandboxResult *result,
                 SandboxTime allowed)
{
    char out[PATH_MAX], path[PATH_MAX];
    Sections answers;
    folder_path(memcheck, pass, "out", out);
    path_make(path, "%s/answers%s", out, pass->job);
    sections_load(path, MAX_ANSWER_BYTES, &answers);
    char *end = run_end_of_probe(result, allowed, &answers);
    if (end != NULL) {
        tell_finding(memcheck, out);
    }
    if (end != NULL && !memcheck->has_finding) {
        tell_trouble(memcheck, out, result, end);
    }
    free(end);
    sections_free(&answers);
}

// ---- All ----------------------------------------------------------------------------------------

// Returns 0, or -1 after one message when the machinery failed.
static int pass_run(Memcheck *memcheck, const Pass *pass, SandboxTime time)
{
    SandboxRun *run = start_pass(memcheck, pass, time);
    if (run == NULL) {
        return -1;
    }
    while (!sandbox_has_ended(run)) {
        progress_show();
        nanosleep(&(struct timespec){.tv_nsec = 20 * 1000 * 1000}, NULL);
    }
    progress_hide();
    SandboxResult result = sandbox_wait(run);
    int failed = 0;
    if (result.outcome == SANDBOX_STARVED) {
        complain("memcheck: this machine is too busy: try again when it is less so");
        failed = -1;
    } else if (result.outcome == SANDBOX_FAULT) {
        complain("memcheck: the sandbox failed: %s", result.output);
        failed = -1;
    } else {
        tell(memcheck, pass, &result, time);
    }
    free(result.output);
    return failed;
}

int memcheck_passes(Memcheck *memcheck)
{
    const int given = memcheck->session.settings->time_limit;
    const Allowance allowance = {.given_seconds = given > 0 ? given : PASS_SECONDS};
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 0);
    // Values that were never set are looked for in kernels.
    const int n_passes = manifest_has_kernels(&memcheck->session.manifest) ? N_PASSES : 1;
    int failed = 0;
    progress_say("running it with a check of each access to memory");
    for (int i = 0; i < n_passes && failed == 0 && !memcheck->has_finding && !memcheck->has_trouble;
         i++) {
        failed = pass_run(memcheck, &passes[i], time);
    }
    return failed;
}
