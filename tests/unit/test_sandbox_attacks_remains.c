// grader/sandbox: attacks that outlive their run, by a process or by what they leave, behind every
// kind of walls.
#include "sandbox_commands.h"
#include "sandbox_user.h"

// ---- Survivors ----------------------------------------------------------------------------------

// For a script: wait until the other process has written something.
#define UNTIL_ALIVE "select(undef, undef, undef, 0.05) until -s q(alive); "

TEST_EACH(a_daemon_does_not_outlive_its_run)
{
    SandboxCommand command = perl_command(
        "use POSIX; if (!fork) { setsid; if (!fork) { for (1..2000) { open(my $f, q(>>), "
        "q(alive)); "
        "syswrite $f, q(x); select(undef, undef, undef, 0.05) } } exit } " UNTIL_ALIVE "exit 4");
    SandboxResult result = command_run(&command);
    cr_expect_eq(result.n_left, sandbox_has_own_user(tested_kind) ? 1 : 0, "%d", result.n_left);
    expect_exit(result, 4);
    struct stat before, after;
    cr_assert_eq(stat("alive", &before), 0);
    sleep_milliseconds(300);
    cr_assert_eq(stat("alive", &after), 0);
    cr_expect_eq(before.st_size, after.st_size, "it is still alive");
}

// A process that is never the same one for longer than a moment: each starts the next and ends.
TEST_EACH(a_chain_of_forks_does_not_outlive_its_run)
{
    SandboxCommand command = perl_command(
        "if (!fork) { for (1..20000) { exit if fork; open(my $f, q(>>), q(alive)); syswrite $f, "
        "q(x) } } " UNTIL_ALIVE "exit 4");
    // On a busy machine a look may count many that have ended: that is another test's.
    command.n_processes = command.total_memory_mb = 0;
    expect_exit(command_run(&command), 4);
    struct stat before, after;
    cr_assert_eq(stat("alive", &before), 0);
    cr_assert_lt(before.st_size, 20000, "the chain was too short to be ended");
    sleep_milliseconds(300);
    cr_assert_eq(stat("alive", &after), 0);
    cr_expect_eq(before.st_size, after.st_size, "it is still alive");
}

// ---- What it leaves -----------------------------------------------------------------------------

TEST_OWN_USER(its_folder_is_removed_whatever_is_in_it)
{
    cr_assert_eq(mkdir("own", 0755), 0);
    char own[128];
    snprintf(own, sizeof own, "%s/own", surroundings_folder);
    setenv("TMPDIR", own, 1);
    SandboxCommand command = perl_command(
        "chdir $ENV{TMPDIR}; for (1..30) { mkdir qq(a); symlink q(/), q(l); chmod 0, q(.) if $_ > "
        "28; chdir q(a) } exit 3");
    expect_exit(command_run(&command), 3);
    cr_expect_eq(rmdir(own), 0, "something is left in it");
}

TEST_OWN_USER(its_folder_is_removed_when_the_grader_is_killed)
{
    cr_assert_eq(mkdir("own", 0755), 0);
    char own[128];
    snprintf(own, sizeof own, "%s/own", surroundings_folder);
    setenv("TMPDIR", own, 1);
    SandboxCommand command = shell_command(": >begun; sleep 300");
    pid_t grader = fork();
    if (grader == 0) {
        sandbox_wait(sandbox_start(&command));
        _exit(0);
    }
    file_await("begun");
    cr_expect_neq(rmdir(own), 0, "the test sees no folder");
    kill(grader, SIGKILL);
    waitpid(grader, NULL, 0);
    for (int i = 0; i < 3000 && rmdir(own) != 0; i++) {
        sleep_milliseconds(20);
    }
    cr_expect_neq(access(own, F_OK), 0, "something is left in it");
}

// Where everybody may write, nobody else's things are touched.
TEST_AS_ROOT(user, what_it_leaves_where_everybody_may_write_is_removed)
static void what_it_leaves_where_everybody_may_write_is_removed(void)
{
    char script[1024], left[128], name[64];
    snprintf(name, sizeof name, "unit-left-%d", (int)getpid());
    cr_assert_eq(mkdir("own", 0755) | mkdir("own/open", 01777), 0);
    cr_assert_eq(chmod("own/open", 01777), 0);
    file_write("own/open/decoy", "x", 1);
    snprintf(left, sizeof left, "%s/own", surroundings_folder);
    setenv("TMPDIR", left, 1);
    snprintf(script, sizeof script,
             "for at in /tmp/%s /dev/shm/%s %s/open/%s; do echo x >$at-file; mkdir -p $at/a/b; "
             "echo x >$at/a/b/c; chmod 0 $at/a; ls -d $at*; done",
             name, name, left, name);
    SandboxResult result = shell_run(script);
    cr_expect_not_null(strstr(result.output, "own/open/unit-left"), "%s", result.output);
    cr_expect_not_null(strstr(result.output, "/tmp/unit-left"), "%s", result.output);
    free(result.output);
    snprintf(script, sizeof script, "ls -d /tmp/%s* /dev/shm/%s* 2>/dev/null", name, name);
    cr_expect_neq(exit_status_outside(script), 0, "it is still there");
    cr_expect_eq(access("own/open/decoy", F_OK), 0, "somebody else's file was removed");
    cr_assert_eq(unlink("own/open/decoy"), 0);
    cr_expect_eq(rmdir("own/open"), 0, "something is left in it");
}

TEST_AS_ROOT(user, what_it_writes_where_everybody_may_write_counts)
static void what_it_writes_where_everybody_may_write_counts(void)
{
    expect_exceeded(shell_run("mkdir /tmp/unit-$$; cd /tmp/unit-$$; for i in $(seq 20); do "
                              "head -c 8M /dev/zero >$i; done; sleep 20"),
                    SANDBOX_LIMIT_BYTES);
}

// Who ends a user's processes has to come to it before anybody kills him in his turn.
TEST_AS_ROOT(user, whoever_ends_its_processes_is_waited_for)
static void whoever_ends_its_processes_is_waited_for(void)
{
    const uid_t user = user_own();
    int has_become[2];
    char byte = 0;
    cr_assert_eq(pipe(has_become), 0);
    const pid_t sleeper = fork();
    if (sleeper == 0) {
        if (user_become(user) == 0 && write(has_become[1], &byte, 1) == 1) {
            sleep(300);
        }
        _exit(0);
    }
    cr_assert_eq(read(has_become[0], &byte, 1), 1);
    user_end(user);
    // The sleeper is the only child: nobody else is left to be killed by mistake.
    int status;
    cr_expect_eq(waitpid(-1, &status, 0), sleeper, "the ender is still a child");
    cr_expect(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL, "status %d", status);
    cr_expect_eq(waitpid(-1, &status, WNOHANG), -1, "another child is left");
}

// The grader's own again: nothing that runs later under a number used before can change it.
TEST_EACH(the_writable_mount_is_taken_back)
{
    struct stat status;
    expect_exit(shell_run("echo x >x; exit 0"), 0);
    cr_assert_eq(stat(".", &status), 0);
    cr_expect_eq(status.st_uid, geteuid());
}
