// grader/sandbox: attacks on the machine, on the grader and on other runs, behind every kind of
// walls. Each is bounded by itself: at most 2000 forks, 1 GB of memory, 320 MB of files.
#include "limited_folder.h"
#include "sandbox_commands.h"

#include "sandbox_user.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <glob.h>
#include <linux/sched.h>
#include <sys/file.h>
#include <sys/shm.h>
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

TEST_EACH(another_runs_folders_cannot_be_touched)
{
    char other[] = "/tmp/unit-XXXXXX", pattern[128];
    cr_assert_not_null(mkdtemp(other));
    cr_assert_eq(chmod(other, 0755), 0);
    setenv("TMPDIR", other, 1);
    snprintf(pattern, sizeof pattern, "%s/sandbox-*/tmp/own", other);
    limited_folder_mount("", 1, 1);  // both runs see what the grader mounts, as in a grading
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
    cr_expect_eq(found.gl_pathc > 0, sandbox_has_own_user(tested_kind), "the test sees no folder");
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

// An answer that is being written, and one that only the grader may read any more.
TEST_EACH(another_runs_mounts_cannot_be_entered)
{
    char out[128], script[512];
    snprintf(out, sizeof out, "%s/out", surroundings_folder);
    cr_assert_eq(mkdir(out, 0700), 0);
    SandboxCommand writer = shell_command(
        "echo secret >answers; chmod a+rw answers; : >begun; " UNTIL_GO "chmod a+rwx .");
    writer.mounts[0].outside = out;
    SandboxRun *run = sandbox_start(&writer);
    cr_assert_not_null(run);
    file_await("out/begun");
    snprintf(script, sizeof script, "ls %s; cat %s/answers; echo forged >>%s/answers", out, out,
             out);
    SandboxCommand reader = shell_command(script);
    reader.mounts[0] = (SandboxMount){.outside = "/usr/share", .inside = "/work"};
    SandboxResult result = command_run(&reader);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    free(result.output);
    file_write("out/go", "", 0);
    expect_exit(sandbox_wait(run), 0);

    result = command_run(&reader);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    free(result.output);
    struct stat status;
    cr_assert_eq(stat("out/answers", &status), 0);
    cr_expect_eq(status.st_size, 7, "it was changed");
    cr_assert_eq(stat("out", &status), 0);
    cr_expect_eq(status.st_mode & 0777, 0700, "mode %o", status.st_mode);
}

// What only the grader may read is opened to the run that it is mounted for.
TEST_EACH(a_closed_mount_is_opened_to_its_run_alone)
{
    char closed[128], script[256];
    struct stat status;
    snprintf(closed, sizeof closed, "%s/closed", surroundings_folder);
    cr_assert_eq(mkdir(closed, 0700), 0);
    file_write("closed/solution", "secret\n", 7);
    SandboxCommand command = shell_command("cat solution; echo x >>solution; echo x >new; ls");
    command.mounts[0] = (SandboxMount){.outside = closed, .inside = "/work"};
    SandboxResult result = command_run(&command);
    cr_expect_eq(strncmp(result.output, "secret\n", 7), 0, "%s", result.output);
    cr_expect_not_null(strstr(result.output, "\nsolution\n"), "%s", result.output);
    free(result.output);
    cr_assert_eq(stat(closed, &status), 0);
    cr_expect_eq(status.st_mode & 0777, 0700, "mode %o", status.st_mode);
    cr_expect_eq(access("closed/new", F_OK), -1, "it was written");

    snprintf(script, sizeof script, "cat %s/solution", closed);
    result = shell_run(script);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    free(result.output);
}

// The gap that Landlock closes, and what an instructor can do about it.
TEST_AS_ROOT(user, only_the_rights_of_files_keep_it_out)
static void only_the_rights_of_files_keep_it_out(void)
{
    char script[256];
    cr_assert_eq(mkdir("open", 0755) | mkdir("closed", 0700), 0);
    file_write("open/solution", "read\n", 5);
    file_write("closed/solution", "secret\n", 7);
    snprintf(script, sizeof script, "cat %s/open/solution %s/closed/solution", surroundings_folder,
             surroundings_folder);
    SandboxCommand command = shell_command(script);
    command.mounts[0] = (SandboxMount){.outside = "/usr/share", .inside = "/work"};
    SandboxResult result = command_run(&command);
    cr_expect_eq(strncmp(result.output, "read\n", 5), 0, "%s", result.output);
    cr_expect_null(strstr(result.output, "secret"), "%s", result.output);
    free(result.output);
}

// ---- Other processes -------------------------------------------------------------------------

TEST_EACH(the_grader_cannot_be_signalled)
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

TEST_EACH(the_network_is_unreachable_even_on_this_machine)
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

TEST_EACH(what_only_an_attack_asks_for_ends_it)
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

TEST_EACH(what_libraries_can_do_without_is_refused)
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
        // What two runs could tell each other something by. Descriptors 0 to 2 are there.
        {"flock", SYS_flock, {0, LOCK_SH, 0}},
        {"fcntl(F_GETLEASE)", SYS_fcntl, {0, F_GETLEASE, 0}},
        {"fcntl(F_GETLEASE) and junk", SYS_fcntl, {0, F_GETLEASE | 1L << 32, 0}},
        {"inotify_init1", SYS_inotify_init1, {0, 0, 0}},
        {"syncfs", SYS_syncfs, {0, 0, 0}},
        {"getpriority", SYS_getpriority, {0, 0, 0}},
        {"clock_gettime of process 1", SYS_clock_gettime, {-14, 0, 0}},
        {"futex_waitv", SYS_futex_waitv, {0, 0, 0}},
        // What no look at the run finds.
        {"memfd_create", SYS_memfd_create, {0, 0, 0}},
        {"close_range(CLOSE_RANGE_UNSHARE)", SYS_close_range, {100, 200, 2}},
        {"a thread with descriptors of its own",
         SYS_clone,
         {CLONE_VM | CLONE_SIGHAND | CLONE_THREAD, 0, 0}},
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
TEST_EACH(calls_of_other_abis_end_it)
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

TEST_EACH(a_fork_bomb_is_named)
{
    expect_exceeded(perl_run("for (1..2000) { my $id = fork; if (defined $id && !$id) { sleep 20; "
                             "exit } } sleep 20"),
                    SANDBOX_LIMIT_PROCESSES);
}

TEST_EACH(memory_of_many_processes_is_summed_up)
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

TEST_EACH(files_are_summed_up)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done; sleep 20"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_EACH(files_written_just_before_the_end_count)
{
    expect_exceeded(shell_run("for i in $(seq 40); do head -c 8M /dev/zero >$i; done"),
                    SANDBOX_LIMIT_BYTES);
}

TEST_EACH(removed_files_count_as_long_as_they_are_open)
{
    expect_exceeded(
        perl_run("my $x = chr(1) x 8e6; my @f; for (1..40) { open(my $f, q(>), q(own)); "
                 "unlink q(own); print $f $x; $f->flush; push @f, $f } sleep 20"),
        SANDBOX_LIMIT_BYTES);
}

TEST_EACH(removed_files_count_as_long_as_a_page_is_mapped)
{
    const char *source =
        "#include <fcntl.h>\n#include <sys/mman.h>\n#include <unistd.h>\nstatic char x[8000000];"
        "int main(void) { x[0] = 1; for (int i = 0; i < 20; i++) { int f = open(\"own\", O_RDWR | "
        "O_CREAT, 0600); unlink(\"own\"); write(f, x, sizeof x); "
        "mmap((void *)(65536L << i), 4096, PROT_READ, MAP_SHARED, f, 0); close(f); } sleep(20); }";
    file_write("held.c", source, strlen(source));
    expect_exceeded(shell_run("gcc -w held.c -o held && exec ./held"), SANDBOX_LIMIT_BYTES);
}

// A process goes on without its first thread, and without any that lives longer than a moment.
static const char *without_first_thread =
    "#include <pthread.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n"
    "void *next(void *n) { pthread_t t; pthread_detach(pthread_self());"
    "if (n == (void *)1) { sleep(20); _exit(0); }"
    "usleep(100); if (pthread_create(&t, 0, next, (char *)n - 1) != 0) _exit(1); return 0; }"
    "int main(int c, char **v) { int i = atoi(v[1]); while (--i > 0 && fork() != 0);"
    "int n = atoi(v[2]) << 20; memset(malloc(n), 1, n);"
    "pthread_t t; pthread_create(&t, 0, next, (void *)atol(v[3])); pthread_exit(0); }";

TEST_EACH(memory_counts_when_the_first_thread_has_ended)
{
    file_write("first.c", without_first_thread, strlen(without_first_thread));
    expect_exceeded(shell_run("gcc -w first.c -o first && exec ./first 10 100 1"),
                    SANDBOX_LIMIT_MEMORY);
    expect_exceeded(shell_run("exec ./first 10 100 20000"), SANDBOX_LIMIT_MEMORY);
}

TEST_OWN_USER(who_is_left_without_a_first_thread_is_counted)
{
    file_write("first.c", without_first_thread, strlen(without_first_thread));
    SandboxResult result = shell_run("gcc -w first.c -o first; ./first 1 1 1 & sleep 1; exit 3");
    cr_expect_eq(result.n_left, 1, "%d", result.n_left);
    expect_exit(result, 3);
}

TEST_EACH(many_files_are_stopped)
{
    expect_exceeded(perl_run("for (1..3000) { open(my $f, q(>), $_) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(files_in_its_temporary_folder_count)
{
    expect_exceeded(perl_run("for (1..3000) { open(my $f, q(>), qq($ENV{TMPDIR}/$_)) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(deep_folders_hide_nothing)
{
    expect_exceeded(perl_run("for (1..60) { mkdir q(a); chdir q(a) } sleep 20"),
                    SANDBOX_LIMIT_FILES);
}

TEST_EACH(links_lead_the_census_nowhere)
{
    expect_exit(shell_run("ln -s / root; ln -s . self; ln -s /usr/lib lib; sleep 0.5; exit 3"), 3);
}

// ---- Survivors -------------------------------------------------------------------------------

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
    expect_exit(command_run(&command), 4);
    struct stat before, after;
    cr_assert_eq(stat("alive", &before), 0);
    cr_assert_lt(before.st_size, 20000, "the chain was too short to be ended");
    sleep_milliseconds(300);
    cr_assert_eq(stat("alive", &after), 0);
    cr_expect_eq(before.st_size, after.st_size, "it is still alive");
}

// ---- What it leaves --------------------------------------------------------------------------

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
    file_write("own/open/stranger", "x", 1);
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
    cr_expect_eq(access("own/open/stranger", F_OK), 0, "somebody else's file was removed");
    cr_assert_eq(unlink("own/open/stranger"), 0);
    cr_expect_eq(rmdir("own/open"), 0, "something is left in it");
}

// Where no filter refuses it.
TEST_AS_ROOT(user, system_v_memory_does_not_outlive_its_run)
static void system_v_memory_does_not_outlive_its_run(void)
{
    char program[256], list[128];
    const int key = 0x556e6974 ^ (int)getpid();
    snprintf(program, sizeof program,
             "exit(defined(shmget(%d, 4096, 01600)) && defined(msgget(%d, 01600)) && "
             "defined(semget(%d, 1, 01600)) ? 3 : 4)",
             key, key, key);
    SandboxCommand command = perl_command(program);
    command.kind = SANDBOX_USER_UNFILTERED;
    expect_exit(command_run(&command), 3);
    snprintf(list, sizeof list, "grep -q '^ *%d ' /proc/sysvipc/*", key);
    cr_expect_neq(exit_status_outside(list), 0, "it is still there");
    const int own = shmget(key, 4096, IPC_CREAT | IPC_EXCL | 0600);
    cr_expect_eq(exit_status_outside(list), 0, "the test sees no memory");
    shmctl(own, IPC_RMID, NULL);
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
