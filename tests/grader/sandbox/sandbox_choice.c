// Which sandbox works on this host (see sandbox.h): tried, not guessed.
//
// Read next: sandbox.c.
#include "sandbox.h"

#include "message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// What to do where bubblewrap itself fails.
static const char advice[] =
    "  bubblewrap 0.8 or newer needs user namespaces, which seem to be off here: `make doctor` "
    "names\n"
    "  the command that turns them on. In a container: grade outside of it, or start it with\n"
    "      --security-opt seccomp=unconfined --security-opt systempaths=unconfined\n";

// What SANDBOX_ANY tries, the strongest first.
static const SandboxKind choices[] = {SANDBOX_BUBBLEWRAP, SANDBOX_LANDLOCK, SANDBOX_USER};

enum { N_CHOICES = sizeof choices / sizeof *choices };

// The kind, in a sentence.
static const char *kind_in_words(SandboxKind kind)
{
    switch (kind) {
    case SANDBOX_LANDLOCK:
        return "Landlock";
    case SANDBOX_USER:
        return "a user of its own for each run";
    default:
        return sandbox_kind_name(kind);
    }
}

// Run a command that does nothing. Returns NULL when that works, else why it does not; free() it.
static char *kind_try(SandboxKind kind)
{
    if (sandbox_has_own_user(kind) && geteuid() != 0) {
        return message_new("%s needs a grader that runs as root", kind_in_words(kind));
    }
    SandboxCommand command = {
        .kind = kind,
        .argv = (const char *const[]){"/usr/bin/true", NULL},
        .folder = "/tmp",
        .time = {.processor = 10, .asleep = 10, .wall = 600},
        .file_mb = 1,
    };
    SandboxRun *run = sandbox_start(&command);
    if (run == NULL) {
        return strdup("");  // reported already
    }
    SandboxResult result = sandbox_wait(run);
    if (result.outcome == SANDBOX_EXITED && result.exit_status == 0) {
        free(result.output);
        return NULL;
    }
    result.output[strcspn(result.output, "\n")] = '\0';
    if (result.output[0] == '\0') {
        snprintf(result.output, SANDBOX_MAX_OUTPUT, "%s was killed", kind_in_words(kind));
    }
    return result.output;
}

// The one message for a sandbox that cannot be made: why none of those that were tried works.
static void refuse(char *const *whys, int n_whys)
{
    fprintf(stderr, "sandbox: %s\n", whys[0]);
    for (int i = 1; i < n_whys; i++) {
        fprintf(stderr, "  nor another one: %s\n", whys[i]);
    }
    if (strncmp(whys[0], "bwrap:", strlen("bwrap:")) == 0) {
        fputs(advice, stderr);
    }
    if (geteuid() != 0 && n_whys > 1) {
        fputs("  your own code may run without walls: COURSE_SANDBOX=none make grade LAB=...\n",
              stderr);
    }
}

// One line about walls other than bubblewrap's: why these.
static void settle_for(SandboxKind kind, char *const *whys, int n_whys)
{
    fputs("sandbox: bubblewrap does not work here (", stderr);
    for (int i = 0; i < n_whys; i++) {
        fprintf(stderr, "%s%s", i > 0 ? "; " : "", whys[i]);
    }
    fprintf(stderr, "): %s is used", kind_in_words(kind));
    if (sandbox_kind_note(kind) != NULL) {
        fputs(", which hides less: the course's tests/README.md, \"The three sandboxes\"", stderr);
    }
    fputc('\n', stderr);
}

int sandbox_choose(SandboxKind wanted, SandboxKind *kind)
{
    char *whys[N_CHOICES] = {NULL};
    int n_whys = 0, is_found = 0;
    const SandboxKind *tried = wanted == SANDBOX_ANY ? choices : &wanted;
    // Without root, all others fail for the same reason: one of them is enough.
    const int n_tried = wanted != SANDBOX_ANY ? 1 : geteuid() != 0 ? 2 : N_CHOICES;
    while (!is_found && n_whys < n_tried) {
        *kind = tried[n_whys];
        whys[n_whys] = kind_try(*kind);
        is_found = whys[n_whys] == NULL;
        n_whys += !is_found;
    }
    if (!is_found) {
        refuse(whys, n_whys);
    } else if (n_whys > 0) {
        settle_for(*kind, whys, n_whys);
    }
    for (int i = 0; i < n_whys; i++) {
        free(whys[i]);
    }
    return is_found ? 0 : -1;
}
