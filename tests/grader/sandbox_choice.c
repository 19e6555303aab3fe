// Which sandbox works on this host (see sandbox.h): tried, not guessed.
//
// Flow: SANDBOX CHOSEN -> staged -> compiled -> run -> judged. Read next: sandbox.c.
#include "sandbox.h"

#include "landlock.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

// Run a command that does nothing. Returns NULL when that works, else why it does not; free() it.
static char *kind_try(SandboxKind kind)
{
    if (kind == SANDBOX_LANDLOCK && geteuid() != 0) {
        return strdup("Landlock needs a grader that runs as root");
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
        return strdup("");  // told already
    }
    SandboxResult result = sandbox_wait(run);
    if (result.outcome == SANDBOX_EXITED && result.exit_status == 0) {
        free(result.output);
        return NULL;
    }
    result.output[strcspn(result.output, "\n")] = '\0';
    if (result.output[0] == '\0') {
        snprintf(result.output, SANDBOX_MAX_OUTPUT, "%s was killed", sandbox_kind_name(kind));
    }
    return result.output;
}

// The one message for a sandbox that cannot be made.
static int refuse(const char *why, const char *why_not_the_other)
{
    fprintf(stderr, "sandbox: %s\n", why);
    if (why_not_the_other != NULL) {
        fprintf(stderr, "  nor the other sandbox: %s\n", why_not_the_other);
    }
    if (strncmp(why, "bwrap:", strlen("bwrap:")) == 0) {
        fputs(advice, stderr);
    }
    return -1;
}

int sandbox_choose(SandboxKind wanted, SandboxKind *kind)
{
    *kind = wanted == SANDBOX_ANY ? SANDBOX_BUBBLEWRAP : wanted;
    char *why = kind_try(*kind);
    char *why_not_the_other = NULL;
    int result = why == NULL ? 0 : -1;
    if (result != 0 && wanted == SANDBOX_ANY) {
        why_not_the_other = kind_try(SANDBOX_LANDLOCK);
        if (why_not_the_other == NULL) {
            *kind = SANDBOX_LANDLOCK;
            result = 0;
            fprintf(stderr, "sandbox: bubblewrap does not work here (%s): Landlock is used\n", why);
        }
    }
    if (result != 0) {
        refuse(why, why_not_the_other);
    }
    free(why);
    free(why_not_the_other);
    return result;
}
