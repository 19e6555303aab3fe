// Commands to be sandboxed, for the tests of every kind of sandbox.
//
// The commands are small scripts, each bounded by itself: where a wall of the sandbox were missing,
// the test would fail and the machine stay well. Where something must be out of reach, the test
// first makes sure that it is there to be reached. Read next: test_sandbox.c.
#ifndef UNIT_SANDBOX_COMMANDS_H
#define UNIT_SANDBOX_COMMANDS_H

#include "sandbox.h"
#include "surroundings.h"

#include <signal.h>
#include <sys/wait.h>
#include <time.h>

enum {
    MAX_FILE_MB = 8,
    MAX_MEMORY_MB = 256,
    MAX_PROCESSES = 24,
    MAX_TOTAL_MEMORY_MB = 512,
    MAX_TOTAL_FILE_MB = 64,
    MAX_FILES = 1000,
};

// The kind that the running test is about.
static SandboxKind tested_kind;

// A test about one kind, which needs root for it.
#define TEST_AS_ROOT(suite, name)                                                                  \
    static void name(void);                                                                        \
    Test(suite, name)                                                                              \
    {                                                                                              \
        if (geteuid() != 0) {                                                                      \
            SKIP_TEST("this sandbox needs root");                                                  \
        }                                                                                          \
        name();                                                                                    \
    }

// A test that must hold where files can be hidden: it becomes one in the suite `bubblewrap` and one
// in the suite `landlock`.
#define TEST_BOTH(name)                                                                            \
    static void name(void);                                                                        \
    Test(bubblewrap, name)                                                                         \
    {                                                                                              \
        name();                                                                                    \
    }                                                                                              \
    TEST_AS_ROOT(landlock, name)                                                                   \
    static void name(void)

// A test that must hold behind every kind of walls: one in the suite `user` besides.
#define TEST_EACH(name)                                                                            \
    static void name(void);                                                                        \
    Test(bubblewrap, name)                                                                         \
    {                                                                                              \
        name();                                                                                    \
    }                                                                                              \
    TEST_AS_ROOT(landlock, name)                                                                   \
    TEST_AS_ROOT(user, name)                                                                       \
    static void name(void)

// A test about runs with a user of their own.
#define TEST_OWN_USER(name)                                                                        \
    TEST_AS_ROOT(landlock, name)                                                                   \
    TEST_AS_ROOT(user, name)                                                                       \
    static void name(void)

static inline void bubblewrap_enter(void)
{
    tested_kind = SANDBOX_BUBBLEWRAP;
    folder_enter();
    cr_assert_eq(chmod(".", 0755), 0);
}

static inline void landlock_enter(void)
{
    tested_kind = SANDBOX_LANDLOCK;
    folder_enter();
    cr_assert_eq(chmod(".", 0755), 0);
}

static inline void user_enter(void)
{
    tested_kind = SANDBOX_USER;
    folder_enter();
    cr_assert_eq(chmod(".", 0755), 0);
}

TestSuite(bubblewrap, .init = bubblewrap_enter, .fini = folder_leave);
TestSuite(landlock, .init = landlock_enter, .fini = folder_leave);
TestSuite(user, .init = user_enter, .fini = folder_leave);

// `script` in a shell, with the current folder as /work. One command at a time in a process.
static inline SandboxCommand shell_command(const char *script)
{
    static const char *argv[] = {"/usr/bin/sh", "-c", NULL, NULL};
    argv[2] = script;
    return (SandboxCommand){
        .kind = tested_kind,
        .argv = argv,
        .folder = "/work",
        .mounts = {{.outside = ".", .inside = "/work", .writable = 1}},
        .n_mounts = 1,
        .time = {.processor = 10, .asleep = 100, .wall = 3000},
        .memory_mb = MAX_MEMORY_MB,
        .file_mb = MAX_FILE_MB,
        .n_processes = MAX_PROCESSES,
        .total_memory_mb = MAX_TOTAL_MEMORY_MB,
        .total_file_mb = MAX_TOTAL_FILE_MB,
        .n_files = MAX_FILES,
    };
}

static inline SandboxResult command_run(const SandboxCommand *command)
{
    SandboxRun *run = sandbox_start(command);
    cr_assert_not_null(run);
    SandboxResult result = sandbox_wait(run);
    cr_assert_not_null(result.output);
    return result;
}

static inline SandboxResult shell_run(const char *script)
{
    SandboxCommand command = shell_command(script);
    return command_run(&command);
}

// A program in Perl, which every Debian has, started directly. Quotes in it would end the string.
static inline SandboxCommand perl_command(const char *program)
{
    static const char *argv[] = {"/usr/bin/perl", "-e", NULL, NULL};
    argv[2] = program;
    SandboxCommand command = shell_command("");
    command.argv = argv;
    return command;
}

static inline SandboxResult perl_run(const char *program)
{
    SandboxCommand command = perl_command(program);
    return command_run(&command);
}

static inline void expect_exit(SandboxResult result, int exit_status)
{
    cr_expect_eq(result.outcome, SANDBOX_EXITED, "outcome %d, signal %d: %s", result.outcome,
                 result.signal, result.output);
    cr_expect_eq(result.exit_status, exit_status, "exit status %d: %s", result.exit_status,
                 result.output);
    free(result.output);
}

static inline void expect_crash(SandboxResult result, int signal_id)
{
    cr_expect_eq(result.outcome, SANDBOX_CRASHED, "outcome %d, exit status %d: %s", result.outcome,
                 result.exit_status, result.output);
    cr_expect_eq(result.signal, signal_id, "signal %d", result.signal);
    free(result.output);
}

static inline void expect_forbidden(SandboxResult result, const char *what)
{
    cr_expect_eq(result.outcome, SANDBOX_FORBIDDEN, "%s: outcome %d, exit status %d: %s", what,
                 result.outcome, result.exit_status, result.output);
    free(result.output);
}

static inline void expect_exceeded(SandboxResult result, SandboxLimit limit)
{
    cr_expect_eq(result.outcome, SANDBOX_EXCEEDED, "outcome %d, exit status %d: %s", result.outcome,
                 result.exit_status, result.output);
    cr_expect_eq(result.limit, limit, "limit %d", result.limit);
    free(result.output);
}

static inline void sleep_milliseconds(long milliseconds)
{
    nanosleep(&(struct timespec){milliseconds / 1000, milliseconds % 1000 * 1000000}, NULL);
}

static inline int exit_status_outside(const char *script)
{
    int status = system(script);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Wait until there is such a file, in this test's folder. Fails only where nothing comes any more.
static inline void file_await(const char *path)
{
    for (int i = 0; i < 30000 && access(path, F_OK) != 0; i++) {
        sleep_milliseconds(10);
    }
    cr_assert_eq(access(path, F_OK), 0, "%s did not come", path);
}

// For a script: wait until the test has made the file "go".
#define UNTIL_GO "until [ -e go ]; do sleep 0.05; done; "

// Processes that a test looks for sleep for a time that no other process sleeps for: 1 minute and a
// fraction that is this process's own.
static inline const char *minute_sleep(const char *before, const char *after)
{
    static char script[256];
    snprintf(script, sizeof script, "%s sleep 60.%d %s", before, (int)getpid(), after);
    return script;
}

// Finds them. The dot in brackets keeps grep from finding its own arguments.
static inline const char *minute_sleep_search(void)
{
    static char script[64];
    snprintf(script, sizeof script, "grep -aqs 'sleep.60[.]%d' /proc/[0-9]*/cmdline",
             (int)getpid());
    return script;
}

static inline int minute_sleep_exists(void)
{
    return exit_status_outside(minute_sleep_search()) == 0;
}

// Wait until it is there, or is not; two seconds at most.
static inline int minute_sleep_becomes(int is_there)
{
    for (int i = 0; i < 1000 && minute_sleep_exists() != is_there; i++) {
        sleep_milliseconds(20);
    }
    return minute_sleep_exists() == is_there;
}

#endif
