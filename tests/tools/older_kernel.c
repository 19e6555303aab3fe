// older_kernel: run a command as if the kernel were an older one, or a container's.
//
//     older_kernel [--no-seccomp] COMMAND ARGUMENT...
//
// Used by the suites to see which sandbox the grader chooses. No Landlock and no close_range; no
// namespaces and mounts: the calls fail as where they are unknown or allowed to nobody.
// --no-seccomp: filters of system calls cannot be made any more either.
#include <errno.h>
#include <sched.h>
#include <seccomp.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <unistd.h>

enum { EXIT_FAULT = 98 };

// Calls that the kernel does not know.
static const int unknown_calls[] = {SCMP_SYS(landlock_create_ruleset), SCMP_SYS(close_range)};

// Calls that are known and not allowed.
static const int forbidden_calls[] = {SCMP_SYS(unshare), SCMP_SYS(setns), SCMP_SYS(mount),
                                      SCMP_SYS(umount2), SCMP_SYS(pivot_root)};

static const unsigned namespace_flags[] = {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET};

#define N_ITEMS(array) (sizeof(array) / sizeof *(array))

static int rules_add(scmp_filter_ctx filter, int without_seccomp)
{
    int fault = seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
    for (size_t i = 0; i < N_ITEMS(unknown_calls); i++) {
        fault |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), unknown_calls[i], 0);
    }
    for (size_t i = 0; i < N_ITEMS(forbidden_calls); i++) {
        fault |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), forbidden_calls[i], 0);
    }
    for (size_t i = 0; i < N_ITEMS(namespace_flags); i++) {
        fault |=
            seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                             SCMP_A0(SCMP_CMP_MASKED_EQ, namespace_flags[i], namespace_flags[i]));
    }
    if (without_seccomp) {
        fault |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(seccomp), 0);
        fault |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1,
                                  SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP));
    }
    return fault;
}

int main(int argc, char **argv)
{
    const int without_seccomp = argc > 1 && strcmp(argv[1], "--no-seccomp") == 0;
    char **command = argv + 1 + without_seccomp;
    if (argc < 2 || *command == NULL) {
        fprintf(stderr, "usage: older_kernel [--no-seccomp] COMMAND ARGUMENT...\n");
        return EXIT_FAULT;
    }
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    if (filter == NULL || rules_add(filter, without_seccomp) != 0 || seccomp_load(filter) != 0) {
        fprintf(stderr, "older_kernel: no filter of system calls can be made here\n");
        return EXIT_FAULT;
    }
    execvp(*command, command);
    fprintf(stderr, "older_kernel: %s: %s\n", *command, strerror(errno));
    return EXIT_FAULT;
}
