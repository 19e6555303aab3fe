// Running one command on code that must not be trusted (see sandbox.h): start, wait, and whether
// it works here at all.
//
// Flow: staged -> compiled HERE -> run HERE -> judged outside. Each run has a process of its own
// that watches over it and leaves its report in memory that both share. Read next:
// sandbox_supervisor.c.
#include "sandbox.h"

#include "bwrap_arguments.h"
#include "sandbox_supervisor.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

struct SandboxRun {
    pid_t supervisor;
    SandboxReport *report;  // shared with it
    char *output;           // [SANDBOX_MAX_OUTPUT + 1] for the result
};

static void run_free(SandboxRun *run)
{
    if (run->report != NULL) {
        munmap(run->report, sizeof *run->report);
    }
    free(run->output);
    free(run);
}

// Everything a run needs before there is a process; NULL when memory runs out.
static SandboxRun *run_new(void)
{
    SandboxRun *run = calloc(1, sizeof *run);
    if (run == NULL) {
        return NULL;
    }
    run->output = malloc(SANDBOX_MAX_OUTPUT + 1);
    void *shared =
        mmap(NULL, sizeof *run->report, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared != MAP_FAILED) {
        run->report = shared;
    }
    if (run->output != NULL && run->report != NULL) {
        return run;
    }
    run_free(run);
    return NULL;
}

unsigned sandbox_user(void)
{
    return geteuid() == 0 ? SANDBOX_NOBODY : geteuid();
}

SandboxRun *sandbox_start(const SandboxCommand *command)
{
    char **bwrap = bwrap_arguments(command);
    if (bwrap == NULL) {
        return NULL;
    }
    SandboxRun *run = run_new();
    pid_t grader = getpid();
    if (run != NULL) {
        run->supervisor = fork();
        if (run->supervisor == 0) {
            sandbox_supervise(command, bwrap, grader, run->report);
        }
    }
    int fault = errno;
    bwrap_arguments_free(bwrap);
    if (run != NULL && run->supervisor > 0) {
        return run;
    }
    fprintf(stderr, "sandbox: cannot start a process: %s\n", strerror(fault));
    if (run != NULL) {
        run_free(run);
    }
    return NULL;
}

// An escape sequence could repaint the instructor's terminal, a NUL would hide what follows it.
static void output_copy(const SandboxReport *report, char *output)
{
    for (size_t i = 0; i < report->n_output; i++) {
        unsigned char byte = (unsigned char)report->output[i];
        int is_control = (byte < ' ' && byte != '\n' && byte != '\t') || byte == 0x7f;
        output[i] = is_control ? '?' : (char)byte;
    }
    output[report->n_output] = '\0';
}

SandboxResult sandbox_wait(SandboxRun *run)
{
    while (waitpid(run->supervisor, NULL, 0) < 0 && errno == EINTR)
        ;
    SandboxReport *report = run->report;
    if (!report->is_complete) {
        // Somebody killed the supervisor, and with it the command.
        report->outcome = SANDBOX_FAULT;
        report->n_output = 0;
    }
    SandboxResult result = {
        .outcome = report->outcome,
        .exit_status = report->exit_status,
        .signal = report->signal,
        .output = run->output,
    };
    output_copy(report, result.output);
    run->output = NULL;
    run_free(run);
    return result;
}

// What to do where bubblewrap itself fails.
static const char advice[] =
    "  bubblewrap 0.8 or newer needs user namespaces, which seem to be off here. Turn them on "
    "with\n"
    "      sysctl user.max_user_namespaces=10000                  (where it is 0)\n"
    "      sysctl kernel.unprivileged_userns_clone=1              (Debian)\n"
    "      sysctl kernel.apparmor_restrict_unprivileged_userns=0  (Ubuntu)\n"
    "  or allow bwrap in an AppArmor profile. In a container: grade outside of it, or start it "
    "with\n"
    "      --security-opt seccomp=unconfined --security-opt systempaths=unconfined\n";

// The one message for a sandbox that cannot be made.
static int refuse(const char *output)
{
    size_t n_output = strcspn(output, "\n");
    fprintf(stderr, "sandbox: %.*s\n", (int)n_output, n_output > 0 ? output : "was killed");
    if (strncmp(output, "bwrap:", strlen("bwrap:")) == 0) {
        fputs(advice, stderr);
    }
    return -1;
}

int sandbox_check(void)
{
    SandboxCommand command = {
        .argv = (const char *const[]){"/usr/bin/true", NULL},
        .folder = "/tmp",
        .wall_seconds = 10,
        .cpu_seconds = 10,
        .file_mb = 1,
    };
    SandboxRun *run = sandbox_start(&command);
    if (run == NULL) {
        return -1;
    }
    SandboxResult result = sandbox_wait(run);
    int works = result.outcome == SANDBOX_EXITED && result.exit_status == 0;
    int status = works ? 0 : refuse(result.output);
    free(result.output);
    return status;
}
