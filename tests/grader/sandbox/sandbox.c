// Running one command on code that must not be trusted (see sandbox.h): start and wait.
//
// Each run has a process of its own that watches over it and leaves its report in memory that both
// share. Read next: sandbox_supervisor.c.
#include "sandbox.h"

#include "sandbox_supervisor.h"
#include "sandbox_walls.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *const kind_names[] = {
    [SANDBOX_BUBBLEWRAP] = "bubblewrap",
    [SANDBOX_LANDLOCK] = "landlock",
    [SANDBOX_USER] = "user",
    [SANDBOX_NONE] = "none",
    [SANDBOX_ANY] = "any",
};

const char *sandbox_kind_name(SandboxKind kind)
{
    return kind_names[kind];
}

int sandbox_kind_find(const char *name, SandboxKind *kind)
{
    for (int i = SANDBOX_BUBBLEWRAP; i <= SANDBOX_ANY; i++) {
        if (strcmp(name, kind_names[i]) == 0) {
            *kind = (SandboxKind)i;
            return 0;
        }
    }
    return -1;
}

int sandbox_is_open(SandboxKind kind)
{
    return kind == SANDBOX_USER;
}

int sandbox_has_own_user(SandboxKind kind)
{
    return kind == SANDBOX_LANDLOCK || sandbox_is_open(kind);
}

const char *sandbox_kind_note(SandboxKind kind)
{
    return sandbox_is_open(kind)
               ? "A user of its own for each run, as neither bubblewrap nor Landlock was used: it "
                 "hid no file that every user of this machine may read; see the course's "
                 "tests/README.md, \"The three sandboxes\"."
               : NULL;
}

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

void sandbox_allow(SandboxRun *run, SandboxTime time)
{
    run->report->processor_allowed = time.processor;
    run->report->asleep_allowed = time.asleep;
    run->report->wall_allowed = time.wall;
}

SandboxTime sandbox_used(const SandboxRun *run)
{
    const SandboxReport *report = run->report;
    return (SandboxTime){.processor = report->processor_used, .asleep = report->asleep_used};
}

SandboxRun *sandbox_start(const SandboxCommand *command)
{
    Walls walls;
    if (walls_prepare(command, &walls) != 0) {
        walls_free(&walls);
        return NULL;
    }
    SandboxRun *run = run_new();
    pid_t grader = getpid();
    if (run != NULL) {
        sandbox_allow(run, command->time);
        run->supervisor = fork();
        if (run->supervisor == 0) {
            sandbox_supervise(&walls, grader, run->report);
        }
    }
    int fault = errno;
    walls_free(&walls);
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

int sandbox_has_ended(const SandboxRun *run)
{
    siginfo_t end = {0};
    const int options = WEXITED | WNOHANG | WNOWAIT;
    return waitid(P_PID, (id_t)run->supervisor, &end, options) != 0 || end.si_pid != 0;
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
        .limit = report->limit,
        .used = report->used,
        .n_left = report->n_left,
        .n_printed = report->n_printed,
        .output = run->output,
    };
    output_copy(report, result.output);
    run->output = NULL;
    run_free(run);
    return result;
}
