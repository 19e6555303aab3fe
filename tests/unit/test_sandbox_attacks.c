// grader/sandbox: attacks on the machine, on the grader and on other runs, behind both kinds of
// walls. Each is bounded by itself: at most 2000 forks, 1 GB of memory, 320 MB of files.
#include "sandbox_commands.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <glob.h>
#include <linux/sched.h>
#include <sys/socket.h>
#include <sys/syscall.h>

// A program in Perl, which every Debian has, started directly. Quotes in it would end the string.
static SandboxCommand perl_command(const char *program)
{
    static const char *argv[] = {"/usr/bin/perl", "-e", NULL, NULL};
    argv[2] = program;
    SandboxCommand command = shell_command("");
    command.argv = argv;
    return command;
}

static SandboxResult perl_run(const char *program)
{
    SandboxCommand command = perl_command(program);
    return command_run(&command);
}

// ---- What must not be read -------------------------------------------------------------------

TEST_BOTH(the_passwords_cannot_be_read)
{
    cr_assert_eq(access("/etc/shadow", F_OK), 0);
    SandboxResult result = shell_run("cat /etc/shadow /etc/passwd /root/.profile 2>/dev/null");
    cr_expect_str_eq(result.output, "", "read: %s", result.output);
    expect_exit(result, 1);
}

// As the solutions, other submissions and the grader's own files: anybody may read it outside.
TEST_BOTH(files_that_everybody_may_read_cannot_be_read)
{
    char other[] = "/tmp/unit-XXXXXX", script[256];
    cr_assert_not_null(mkdtemp(other));
    cr_assert_eq(chmod(other, 0755), 0);
    cr_assert_eq(symlink(other, "there"), 0);
    file_write("there/solution", "secret\n", 7);
    cr_assert_eq(chmod("there/solution", 0644), 0);
    snprintf(script, sizeof script,
             "ls %s there there/; cat there/solution %s/solution; ln %s/solution mine; "
             "ln -s %s/solution link; cat mine link",
             other, other, other, other);
    SandboxResult result = shell_run(script);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    cr_expect_null(strstr(result.output, "\nsolution\n"), "%s", result.output);
    free(result.output);
    cr_assert_eq(unlink("there/solution") | rmdir(other), 0);
}

TEST_BOTH(another_runs_folders_cannot_be_touched)
{
    char other[] = "/tmp/unit-XXXXXX", pattern[128];
    cr_assert_not_null(mkdtemp(other));
    cr_assert_eq(chmod(other, 0755), 0);
    setenv("TMPDIR", other, 1);
    snprintf(pattern, sizeof pattern, "%s/sandbox-*/tmp/own", other);
    SandboxCommand writer = shell_command("echo secret >$TMPDIR/own; chmod -R a+rwX $TMPDIR\n"
                                          "echo $TMPDIR; : >begun; " UNTIL_GO "cat $TMPDIR/own");
    SandboxRun *run = sandbox_start(&writer);
    cr_assert_not_null(run);
    file_await("begun");
    glob_t found = {0};
    char script[512] = "true";
    if (glob(pattern, 0, NULL, &found) == 0) {
        snprintf(script, sizeof script, "cat %s; echo forged >%s; rm -f %s", found.gl_pathv[0],
                 found.gl_pathv[0], found.gl_pathv[0]);
    }
    cr_expect_eq(found.gl_pathc > 0, tested_kind == SANDBOX_LANDLOCK, "the test sees no folder");
    globfree(&found);
    SandboxCommand reader = shell_command(script);
    reader.mounts[0].writable = 0;
    SandboxResult result = command_run(&reader);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    free(result.output);
    file_write("go", "", 0);
    result = sandbox_wait(run);
    cr_expect_not_null(strstr(result.output, "\nsecret\n"), "%s", result.output);
    free(result.output);
    cr_expect_eq(rmdir(other), 0);
}

// ---- Other processes -------------------------------------------------------------------------

TEST_BOTH(the_grader_cannot_be_signalled)
{
    pid_t sleeper = fork();
    if (sleeper == 0) {
        sleep(300);
        _exit(0);
    }
    char script[128];
    snprintf(script, sizeof script, "for id in %d %d; do kill -KILL $id && echo done; done",
             (int)getpid(), (int)sleeper);
    SandboxResult result = shell_run(script);
    cr_expect_null(strstr(result.output, "done"), "%s", result.output);
    free(result.output);
    cr_expect_eq(waitpid(sleeper, NULL, WNOHANG), 0, "a process outside was killed");
    kill(sleeper, SIGKILL);
}

// ---- Forbidden calls -------------------------------------------------------------------------

TEST_BOTH(the_network_is_unreachable_even_on_this_machine)
{
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t n_bytes = sizeof address;
    cr_assert_eq(bind(listener, (struct sockaddr *)&address, n_bytes), 0);
    cr_assert_eq(listen(listener, 4), 0);
    cr_assert_eq(getsockname(listener, (struct sockaddr *)&address, &n_bytes), 0);

    char script[128];
    snprintf(script, sizeof script, "exec bash -c 'exec 3<>/dev/tcp/127.0.0.1/%d'",
             ntohs(address.sin_port));
    cr_assert_eq(exit_status_outside(script), 0);
    expect_forbidden(shell_run(script), "a connection");
    cr_assert_eq(accept4(listener, NULL, NULL, SOCK_CLOEXEC) >= 0, 1);  // the test's own
    cr_assert_eq(fcntl(listener, F_SETFL, O_NONBLOCK), 0);
    cr_expect_lt(accept4(listener, NULL, NULL, SOCK_CLOEXEC), 0, "it was reached from inside");
    close(listener);
}

TEST_BOTH(what_only_an_attack_asks_for_ends_it)
{
    const struct {
        const char *name;
        long call, arguments[2];
    } attacks[] = {
        {"socket(AF_INET6)", SYS_socket, {AF_INET6, SOCK_DGRAM}},
        {"socket(AF_PACKET)", SYS_socket, {AF_PACKET, SOCK_RAW}},
        {"ptrace", SYS_ptrace, {0, 0}},
        {"process_vm_readv", SYS_process_vm_readv, {1, 0}},
        {"io_uring_setup", SYS_io_uring_setup, {8, 0}},
        {"unshare(CLONE_NEWUSER)", SYS_unshare, {CLONE_NEWUSER, 0}},
        {"clone(CLONE_NEWUSER)", SYS_clone, {CLONE_NEWUSER | SIGCHLD, 0}},
        {"setns", SYS_setns, {0, 0}},
        {"mount", SYS_mount, {0, 0}},
        {"bpf", SYS_bpf, {0, 0}},
        {"perf_event_open", SYS_perf_event_open, {0, 0}},
        {"userfaultfd", SYS_userfaultfd, {0, 0}},
        {"keyctl", SYS_keyctl, {0, 0}},
        {"open_by_handle_at", SYS_open_by_handle_at, {0, 0}},
        {"kexec_load", SYS_kexec_load, {0, 0}},
        {"init_module", SYS_init_module, {0, 0}},
        {"reboot", SYS_reboot, {0, 0}},  // without its magic numbers: an error outside
        {"swapoff", SYS_swapoff, {0, 0}},
    };
    for (size_t i = 0; i < sizeof attacks / sizeof *attacks; i++) {
        char program[128];
        snprintf(program, sizeof program, "syscall(%ld, %ld, %ld, 0, 0, 0); print 1",
                 attacks[i].call, attacks[i].arguments[0], attacks[i].arguments[1]);
        expect_forbidden(perl_run(program), attacks[i].name);
    }
}

TEST_BOTH(what_libraries_can_do_without_is_refused)
{
    const struct {
        const char *name;
        long call, arguments[3];
    } calls[] = {
        {"socket(AF_UNIX)", SYS_socket, {AF_UNIX, SOCK_STREAM, 0}},
        {"socket(AF_NETLINK)", SYS_socket, {AF_NETLINK, SOCK_RAW, 0}},
        {"shmget", SYS_shmget, {0, 4096, 01600}},
        {"msgget", SYS_msgget, {0, 01600, 0}},
        {"clone3", SYS_clone3, {0, 0, 0}},
        {"personality", SYS_personality, {0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        char program[128];
        snprintf(program, sizeof program, "exit(syscall(%ld, %ld, %ld, %ld) < 0 ? 7 : 0)",
                 calls[i].call, calls[i].arguments[0], calls[i].arguments[1],
                 calls[i].arguments[2]);
        SandboxResult result = perl_run(program);
        cr_expect_eq(result.exit_status, 7, "%s: outcome %d", calls[i].name, result.outcome);
        free(result.output);
    }
}

#ifdef __x86_64__
// The same calls by their numbers in other ABIs: getpid as a 32-bit call, and as an x32 one.
TEST_BOTH(calls_of_other_abis_end_it)
{
    const char *source =
        "int main(void) { int id; __asm__ volatile(\"int $0x80\" : \"=a\"(id) : \"a\"(20)); "
        "return id < 0; }\n";
    file_write("abi.c", source, strlen(source));
    cr_assert_eq(exit_status_outside("gcc -o abi abi.c"), 0);
    expect_forbidden(shell_run("exec ./abi"), "a 32-bit call");
    expect_forbidden(perl_run("syscall(0x40000000 + 39)"), "an x32 call");
}
#endif

// ---- Limits on all processes together --------------------------------------------------------

TEST_BOTH(a_fork_bomb_is_named)
{
    expect_exceeded(perl_run("for (1..2000) { my $id = fork; if (defined $id && !$id) { sleep 20; "
                             "exit } } sleep 20"),
                    SANDBOX_LIMIT_PROCESSES);
}

TEST_BOTH(memory_of_many_processes_is_summed_up)
{
    // Each within its own limit.
    expect_exceeded(perl_run("for (1..10) { if (!fork) { my $x = chr(1) x 1e8; sleep 20; exit } } "
                             "sleep 20"),
                    SANDBOX_LIMIT_MEMORY);
    // What a process and its children share is counted once.
    expect_exit(perl_run("my $x = chr(1) x 1e8; for (1..10) { if (!fork) { sleep 1; exit } } "
                         "sleep 1; exit 3"),
                3);
}

TEST_BOTH(files_are_summed_up)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done; sleep 20"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_BOTH(files_written_just_before_the_end_count)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_BOTH(removed_files_count_as_long_as_they_are_open)
{
    expect_exceeded(
        perl_run("my $x = chr(1) x 8e6; my @f; for (1..40) { open(my $f, q(>), q(own)); "
                 "unlink q(own); print $f $x; $f->flush; push @f, $f } sleep 20"),
        SANDBOX_LIMIT_BYTES);
}

TEST_BOTH(many_files_are_stopped)
{
    expect_exceeded(perl_run("for (1..3000) { open(my $f, q(>), $_) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_BOTH(deep_folders_hide_nothing)
{
    expect_exceeded(perl_run("for (1..60) { mkdir q(a); chdir q(a) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_BOTH(links_lead_the_census_nowhere)
{
    expect_exit(shell_run("ln -s / root; ln -s . self; ln -s /usr/lib lib; sleep 0.5; exit 3"), 3);
}

// ---- Survivors -------------------------------------------------------------------------------

// For a script: wait until the other process has written something.
#define UNTIL_ALIVE "select(undef, undef, undef, 0.05) until -s q(alive); "

TEST_BOTH(a_daemon_does_not_outlive_its_run)
{
    SandboxCommand command = perl_command(
        "use POSIX; if (!fork) { setsid; if (!fork) { for (1..2000) { open(my $f, q(>>), "
        "q(alive)); "
        "syswrite $f, q(x); select(undef, undef, undef, 0.05) } } exit } " UNTIL_ALIVE "exit 4");
    SandboxResult result = command_run(&command);
    cr_expect_eq(result.n_left, tested_kind == SANDBOX_LANDLOCK ? 1 : 0, "%d", result.n_left);
    expect_exit(result, 4);
    struct stat before, after;
    cr_assert_eq(stat("alive", &before), 0);
    sleep_milliseconds(300);
    cr_assert_eq(stat("alive", &after), 0);
    cr_expect_eq(before.st_size, after.st_size, "it is still alive");
}

// A process that is never the same one for longer than a moment: each starts the next and ends.
TEST_BOTH(a_chain_of_forks_does_not_outlive_its_run)
{
    SandboxCommand command = perl_command(
        "if (!fork) { for (1..20000) { exit if fork; open(my $f, q(>>), q(alive)); syswrite $f, "
        "q(x) } } " UNTIL_ALIVE "exit 4");
    expect_exit(command_run(&command), 4);
    struct stat before, after;
    cr_assert_eq(stat("alive", &before), 0);
    cr_assert_lt(before.st_size, 20000, "the chain was too short to be ended");
    sleep_milliseconds(300);
    cr_assert_eq(stat("alive", &after), 0);
    cr_expect_eq(before.st_size, after.st_size, "it is still alive");
}

// ---- What it leaves --------------------------------------------------------------------------

Test(landlock, its_folder_is_removed_whatever_is_in_it)
{
    if (geteuid() != 0) {
        SKIP_TEST("this sandbox needs root");
    }
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

Test(landlock, its_folder_is_removed_when_the_grader_is_killed)
{
    if (geteuid() != 0) {
        SKIP_TEST("this sandbox needs root");
    }
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

// The grader's own again: nothing that runs later under a number used before can change it.
TEST_BOTH(the_writable_mount_is_taken_back)
{
    struct stat status;
    expect_exit(shell_run("echo x >x; exit 0"), 0);
    cr_assert_eq(stat(".", &status), 0);
    cr_expect_eq(status.st_uid, geteuid());
}
