// grader/sandbox: what a command inside can reach, how it is stopped, and how its end is told, the
// same behind every kind of walls. Attacks stand in test_sandbox_attacks.c.
#include "sandbox_commands.h"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

// ---- Out of reach ----------------------------------------------------------------------------

// Behind Landlock what may not be opened can still be seen to be there.
Test(bubblewrap, the_hosts_secrets_and_homes_are_not_there)
{
    cr_assert_eq(access("/etc/shadow", F_OK), 0);
    cr_assert_eq(access("/root", F_OK), 0);
    char script[256];
    snprintf(script, sizeof script,
             "ls -d /etc/shadow /etc/passwd /root /home /var /run /boot /mnt /srv %s 2>/dev/null\n"
             "find /etc /tmp -maxdepth 1 -name passwd -o -name 'unit-*'",
             surroundings_folder);
    SandboxResult result = shell_run(script);
    cr_expect_str_eq(result.output, "", "visible: %s", result.output);
    free(result.output);
}

TEST_BOTH(other_processes_are_not_visible)
{
    pid_t sleeper = fork();
    if (sleeper == 0) {
        char seconds[32];
        snprintf(seconds, sizeof seconds, "60.%d", (int)getppid());
        execl("/bin/sleep", "sleep", seconds, NULL);
        _exit(1);
    }
    cr_assert(minute_sleep_becomes(1));
    SandboxResult result = shell_run(minute_sleep_search());
    cr_expect(result.outcome == SANDBOX_EXITED && result.exit_status != 0, "it was found");
    free(result.output);
    kill(sleeper, SIGKILL);
    waitpid(sleeper, NULL, 0);
}

TEST_BOTH(nothing_but_writable_mounts_can_be_written)
{
    char given[] = "/tmp/unit-XXXXXX";
    cr_assert_not_null(mkdtemp(given));
    cr_assert_eq(chmod(given, 0777), 0);
    cr_assert_eq(symlink(given, "given"), 0);
    file_write("given/own", "x", 1);
    cr_assert_eq(chmod("given/own", 0666), 0);
    SandboxCommand command = shell_command(
        "given=$TMPDIR/../given\n"
        "for file in /x /usr/x /usr/bin/x /etc/x /etc/OpenCL/x /dev/x /sys/x $TMPDIR/../x \\\n"
        "    $given/x $given/own; do (echo x >$file) 2>/dev/null && echo $file; done\n"
        "(rm -f $given/own; ln $given/own .; mv x $given) 2>/dev/null\n"
        "echo x >$TMPDIR/x && echo x >x");
    command.mounts[1] = (SandboxMount){.outside = given, .inside = "/given"};
    command.n_mounts = 2;
    SandboxResult result = command_run(&command);
    cr_expect_null(strchr(result.output, '/'), "written: %s", result.output);
    expect_exit(result, 0);
    cr_expect_eq(access("x", F_OK), 0, "the writable mount was not written");
    cr_expect_eq(access("given/own", F_OK), 0, "a given file was removed");
    cr_expect_neq(access("own", F_OK), 0, "a given file was taken over");
    cr_expect_neq(access("given/x", F_OK), 0);
    cr_assert_eq(unlink("given/own") | rmdir(given), 0);
}

// A mount inside another one: behind Landlock their folders are made for the run.
TEST_EACH(a_umask_that_closes_folders_changes_nothing)
{
    SandboxCommand command = shell_command("cat given/deep/file");
    umask(022);
    mkdir("given", 0755);
    mkdir("given/deep", 0755);  // where bubblewrap mounts
    mkdir("outside", 0755);
    file_write("outside/file", "read", 4);
    command.mounts[1] = (SandboxMount){.outside = "outside", .inside = "/work/given/deep"};
    command.n_mounts = 2;
    umask(077);
    SandboxResult result = command_run(&command);
    cr_expect_str_eq(result.output, "read");
    expect_exit(result, 0);
}

TEST_EACH(runs_as_an_ordinary_user_without_rights)
{
    SandboxResult result = shell_run("id -u; while read -r name value; do\n"
                                     "case $name in CapEff: | NoNewPrivs: | Seccomp:) echo $value; "
                                     "esac; done </proc/self/status");
    char *rest;
    const unsigned long user = strtoul(result.output, &rest, 10);
    cr_expect_str_eq(rest, "\n0000000000000000\n1\n2\n", "%s", result.output);
    cr_expect_neq(user, 0);
    cr_expect(geteuid() != 0 || user > 0x70000000, "user %lu", user);
    free(result.output);
}

TEST_EACH(the_graders_environment_and_open_files_stay_outside)
{
    setenv("GRADER_SECRET", "hunter2", 1);
    file_write("seed", "4711", 4);
    cr_assert_eq(dup2(open("seed", O_RDONLY), 77), 77);  // without close-on-exec
    SandboxCommand command = shell_command(
        "cat /proc/[0-9]*/environ | tr '\\0' '\\n'; echo HOME is $HOME, SEED is $SEED\n"
        "ls -d /proc/[0-9]*/fd/77");
    command.environment = (const char *const[]){"SEED=a b=c", NULL};
    SandboxResult result = command_run(&command);
    cr_expect_null(strstr(result.output, "hunter2"), "%s", result.output);
    cr_expect_not_null(strstr(result.output, "/tmp, SEED is a b=c\n"), "%s", result.output);
    expect_exit(result, 2);  // of ls: no such descriptor
}

// ---- Limits ----------------------------------------------------------------------------------

TEST_EACH(a_file_over_its_limit_is_stopped)
{
    expect_crash(shell_run("exec head -c 40M /dev/zero >large"), SIGXFSZ);
    struct stat status;
    cr_assert_eq(stat("large", &status), 0);
    cr_expect_eq(status.st_size, MAX_FILE_MB * 1024 * 1024);
}

// Behind Landlock they are folders on a disk, which the census counts.
Test(bubblewrap, its_folders_in_memory_are_bounded)
{
    SandboxResult result = shell_run("for folder in /tmp /dev/shm; do for i in $(seq 40); do\n"
                                     "head -c 8M /dev/zero >$folder/$i || break; done; done 2>&1\n"
                                     "du -sm /tmp /dev/shm");
    cr_expect_not_null(strstr(result.output, "256\t/tmp\n64\t/dev/shm\n"), "%s", result.output);
    free(result.output);
}

TEST_EACH(a_memory_hog_is_stopped)
{
    // dd takes its block from memory at once: within the limit, and beyond it.
    expect_exit(shell_run("dd if=/dev/zero of=/dev/null bs=100M count=1 2>/dev/null"), 0);
    expect_exit(shell_run("dd if=/dev/zero of=/dev/null bs=600M count=1 2>/dev/null"), 1);
}

TEST_EACH(a_burst_of_processes_is_stopped)
{
    SandboxResult result = shell_run("for i in $(seq 60); do sleep 20 & echo $i; done 2>/dev/null");
    cr_expect_not_null(strstr(result.output, "\n20\n"), "stopped too early: %s", result.output);
    cr_expect_null(strstr(result.output, "\n24\n"), "%s", result.output);
    free(result.output);
}

TEST_EACH(processes_outside_do_not_count)
{
    // Another run takes almost all that it may; this one has its own count.
    SandboxCommand command = shell_command("for i in $(seq 20); do sleep 1 & done; wait");
    cr_assert_eq(mkdir("first", 0755) | mkdir("second", 0755), 0);
    command.mounts[0].outside = "first";  // a writable mount is one run's at a time
    SandboxRun *first = sandbox_start(&command);
    command.mounts[0].outside = "second";
    SandboxResult second = command_run(&command);
    SandboxResult result = sandbox_wait(first);
    expect_exit(second, 0);
    expect_exit(result, 0);
}

// ---- Time ------------------------------------------------------------------------------------
//
// None of these looks at a clock of its own: on a busy machine everything takes longer.

// Run it, and see which of its times it used up. Returns what it used.
static SandboxTime expect_end(const SandboxCommand *command, SandboxOutcome outcome)
{
    SandboxResult result = command_run(command);
    cr_expect_eq(result.outcome, outcome, "outcome %d after %.1f s of processor, %.1f s asleep: %s",
                 result.outcome, result.used.processor, result.used.asleep, result.output);
    free(result.output);
    return result.used;
}

TEST_EACH(an_endless_loop_ends_when_its_processor_time_is_used_up)
{
    SandboxCommand command = shell_command("while :; do :; done");
    command.time.processor = 1;
    const SandboxTime used = expect_end(&command, SANDBOX_TIMED_OUT);
    cr_expect(used.processor >= 1, "used %.2f s", used.processor);
    // Waiting for a processor is not sleeping, however long it takes.
    cr_expect_lt(used.asleep, 1, "asleep %.2f s", used.asleep);
}

TEST_EACH(loops_of_all_processes_count_together)
{
    // Each of them used little: what ended is remembered, what runs is added.
    SandboxCommand command =
        shell_command("while :; do timeout 0.2 sh -c 'while :; do :; done'; done & "
                      "while :; do :; done");
    command.time.processor = 2;
    const SandboxTime used = expect_end(&command, SANDBOX_TIMED_OUT);
    cr_expect(used.processor >= 2, "used %.2f s", used.processor);
}

TEST_EACH(a_handler_of_sigxcpu_wins_nothing)
{
    SandboxCommand command = shell_command("trap '' XCPU TERM INT; while :; do :; done");
    command.time.processor = 1;
    expect_end(&command, SANDBOX_TIMED_OUT);
}

TEST_EACH(what_is_allowed_can_change_while_it_runs)
{
    SandboxCommand command = shell_command("while :; do :; done");
    command.time = (SandboxTime){600, 600, 6000};
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    sandbox_allow(run, (SandboxTime){.processor = 1, .asleep = 600, .wall = 6000});
    SandboxResult result = sandbox_wait(run);
    cr_expect_eq(result.outcome, SANDBOX_TIMED_OUT);
    cr_expect_lt(result.used.processor, 600);
    free(result.output);
}

TEST_EACH(a_sleeper_ends_when_its_time_asleep_is_used_up)
{
    SandboxCommand command = shell_command("echo begun; sleep 1000");
    command.time.asleep = 1;
    const SandboxTime used = expect_end(&command, SANDBOX_ASLEEP);
    cr_expect(used.asleep >= 1 && used.processor < 1, "asleep %.2f s, processor %.2f s",
              used.asleep, used.processor);
}

TEST_EACH(a_stopped_process_is_asleep)
{
    SandboxCommand command = shell_command("kill -STOP $$");
    command.time.asleep = 1;
    expect_end(&command, SANDBOX_ASLEEP);
}

TEST_EACH(who_waits_for_a_child_is_asleep_in_whatever_state)
{
    // The state of who waits in vfork() is that of who waits for a disk.
    SandboxCommand command = shell_command(
        "echo '#include <unistd.h>\nint main(void) { if (vfork() == 0) { sleep(1000); } }' >v.c\n"
        "gcc -w v.c -o v && exec ./v");
    command.time.asleep = 1;
    expect_end(&command, SANDBOX_ASLEEP);
}

TEST_EACH(closing_the_output_does_not_hide_a_sleeper)
{
    SandboxCommand command = shell_command("exec >/dev/null 2>&1; sleep 1000");
    command.time.asleep = 1;
    expect_end(&command, SANDBOX_ASLEEP);
}

// Loops of nobody's run on the processor that this test is on first.
static void others_start(pid_t others[], int n)
{
    cpu_set_t all, one;
    CPU_ZERO(&one);
    cr_assert_eq(sched_getaffinity(0, sizeof all, &all), 0);
    for (int cpu = 0; CPU_COUNT(&one) == 0; cpu++) {
        if (CPU_ISSET(cpu, &all)) {
            CPU_SET(cpu, &one);
        }
    }
    for (int i = 0; i < n; i++) {
        others[i] = fork();
        if (others[i] == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            sched_setaffinity(0, sizeof one, &one);
            for (;;) {
            }
        }
    }
}

#define ON_ONE_PROCESSOR                                                                           \
    "taskset -c $(taskset -cp $$ | sed 's/.*: //; s/[-,].*//') sh -c 'while :; do :; done'"

TEST_EACH(who_was_kept_waiting_for_a_processor_was_starved)
{
    // Five loops on one processor, of which one is the run's: it waits four fifths of the time.
    enum { N_OTHERS = 4 };
    pid_t others[N_OTHERS];
    others_start(others, N_OTHERS);
    SandboxCommand command = shell_command(ON_ONE_PROCESSOR);
    command.time = (SandboxTime){.processor = 600, .asleep = 600, .wall = 3};
    expect_end(&command, SANDBOX_STARVED);
    for (int i = 0; i < N_OTHERS; i++) {
        kill(others[i], SIGKILL);
        waitpid(others[i], NULL, 0);
    }
}

TEST_EACH(who_keeps_itself_waiting_was_not_starved)
{
    // Far more loops than processors, which wait for each other.
    SandboxCommand command = shell_command(
        "for i in $(seq $((4 + 4 * $(nproc)))); do " ON_ONE_PROCESSOR " & done; wait");
    command.time = (SandboxTime){.processor = 600, .asleep = 600, .wall = 3};
    command.n_processes = 512;
    expect_end(&command, SANDBOX_OVERDUE);
}

TEST_EACH(who_waits_behind_a_thread_was_not_starved)
{
    // In vfork()'s state, but what it waits for is a thread, or its own brother.
    SandboxCommand command = shell_command(
        "echo '#define _GNU_SOURCE\n#include <sched.h>\n#include <signal.h>\n#include <unistd.h>\n"
        "static char stack[65536]; int pause_on(void *a) { for (;;) pause(); }\n"
        "int main(void) { clone(pause_on, stack + 65536, CLONE_VM | CLONE_VFORK | CLONE_PARENT |"
        " SIGCHLD, 0); }' >v.c\ngcc -w v.c -o v && exec ./v");
    command.time = (SandboxTime){.processor = 600, .asleep = 600, .wall = 3};
    expect_end(&command, SANDBOX_OVERDUE);
}

TEST_EACH(time_runs_without_anybody_waiting)
{
    SandboxCommand command = shell_command("echo x >begun; sleep 1000; echo x >late");
    command.time.asleep = 1;
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    siginfo_t ended;
    cr_assert_eq(waitid(P_ALL, 0, &ended, WEXITED | WNOWAIT), 0);
    SandboxResult result = sandbox_wait(run);
    cr_expect_eq(result.outcome, SANDBOX_ASLEEP);
    free(result.output);
}

// ---- The end ---------------------------------------------------------------------------------

TEST_EACH(a_background_process_is_gone_when_the_command_ends)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", "& " UNTIL_GO "exit 4"));
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    cr_assert(minute_sleep_becomes(1), "the test sees no processes inside");
    file_write("go", "", 0);
    SandboxResult result = sandbox_wait(run);
    cr_expect_eq(result.n_left, sandbox_has_own_user(tested_kind) ? 1 : 0, "%d", result.n_left);
    expect_exit(result, 4);
    cr_expect_not(minute_sleep_exists());
}

TEST_EACH(a_background_process_is_gone_after_a_time_out)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", ">/dev/null 2>&1 & sleep 30"));
    command.time.asleep = 1;
    expect_end(&command, SANDBOX_ASLEEP);
    cr_expect_not(minute_sleep_exists());
}

TEST_EACH(everything_is_gone_when_the_grader_is_killed)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", "& sleep 300"));
    pid_t grader = fork();
    if (grader == 0) {
        sandbox_wait(sandbox_start(&command));
        _exit(0);
    }
    cr_assert(minute_sleep_becomes(1));
    kill(grader, SIGKILL);
    waitpid(grader, NULL, 0);
    cr_expect(minute_sleep_becomes(0));
}

TEST_EACH(exit_codes_and_signals_are_told_apart)
{
    expect_exit(shell_run("exit 0"), 0);
    expect_exit(shell_run("exit 3"), 3);
    expect_exit(shell_run("exit 255"), 255);
    expect_crash(shell_run("kill -SEGV $$"), SIGSEGV);
    expect_crash(shell_run("kill -ABRT $$"), SIGABRT);
    expect_crash(shell_run("kill -KILL $$"), SIGKILL);  // but no time-out
}

TEST_EACH(a_command_cannot_pass_for_a_fault_of_the_sandbox)
{
    // What the kernel refuses to execute: no interpreter, no permission, no file.
    file_write("program", "#!/absent\n", 10);
    cr_assert_eq(chmod("program", 0755), 0);
    SandboxCommand command = shell_command("");
    command.argv = (const char *const[]){"./program", NULL};
    expect_exit(command_run(&command), 127);
    cr_assert_eq(chmod("program", 0644), 0);
    expect_exit(command_run(&command), 126);
    command.argv = (const char *const[]){"./absent", NULL};
    expect_exit(command_run(&command), 127);
    expect_exit(shell_run("echo 'bwrap: no'; kill -KILL 1; kill -KILL -1; exit 1"), 1);
}

Test(bubblewrap, process_1_is_closed_to_what_is_inside)
{
    expect_exit(shell_run("cd /proc/1; (: <mem || : >mem || : <maps || ls fd/ || readlink exe ||"
                          "cat environ auxv) 2>/dev/null && exit 1; exit 3"),
                3);
}

// The first child of a process.
static pid_t child_of(pid_t process)
{
    char path[64];
    long child = 0;
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", (int)process, (int)process);
    FILE *children = fopen(path, "r");
    cr_assert(children != NULL && fscanf(children, "%ld", &child) == 1);
    fclose(children);
    return (pid_t)child;
}

// Who runs it has gone to other trouble than a submission could: but from here both look the same.
Test(bubblewrap, a_strange_end_of_its_sandbox_is_the_commands_own)
{
    SandboxCommand command = shell_command("echo x >begun; sleep 100");
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    file_await("begun");
    kill(child_of(child_of(getpid())), SIGKILL);  // bwrap, below its supervisor
    expect_crash(sandbox_wait(run), SIGKILL);
}

Test(bubblewrap, a_sandbox_that_cannot_be_made_is_a_fault)
{
    SandboxCommand command = shell_command("exit 0");
    command.mounts[0].inside = "/usr/bin/true/work";
    SandboxResult result = command_run(&command);
    cr_expect_eq(result.outcome, SANDBOX_FAULT);
    cr_expect_not_null(strstr(result.output, "bwrap: "), "%s", result.output);
    free(result.output);
}

TEST_OWN_USER(without_a_folder_of_its_own_it_is_a_fault)
{
    setenv("TMPDIR", "/nowhere", 1);
    SandboxResult result = shell_run("exit 0");
    cr_expect_eq(result.outcome, SANDBOX_FAULT);
    cr_expect_not_null(strstr(result.output, "TMPDIR"), "%s", result.output);
    free(result.output);
}

TEST_EACH(an_absent_mount_is_told_at_the_start)
{
    SandboxCommand command = shell_command("exit 0");
    command.mounts[0].outside = "absent\n\033[2J";
    capture_begin(2);
    SandboxRun *run = sandbox_start(&command);
    expect_one_message(capture_end(2), "sandbox: absent \xEF\xBF\xBD[2J: No such file");
    cr_expect_null(run);
}

// ---- Output ----------------------------------------------------------------------------------

TEST_EACH(output_is_kept_up_to_a_bound_and_read_to_the_end)
{
    SandboxResult result = shell_run("head -c 50M /dev/zero | tr '\\0' x; echo end >&2; exit 5");
    cr_expect_eq(strlen(result.output), SANDBOX_MAX_OUTPUT);
    cr_expect_eq(strspn(result.output, "x"), SANDBOX_MAX_OUTPUT);
    cr_expect_eq(result.n_printed, 50 * 1024 * 1024 + 4, "%llu", result.n_printed);
    expect_exit(result, 5);
}

TEST_EACH(control_characters_are_replaced)
{
    SandboxResult result =
        shell_run("printf 'a\\tb\\033[2Jc\\000d\\r\\177\\303\\244\\n'; printf e >&2");
    cr_expect_str_eq(result.output, "a\tb?[2Jc?d??\303\244\ne", "%s", result.output);
    expect_exit(result, 0);
}

TEST_EACH(two_run_at_the_same_time_and_end_in_any_order)
{
    const char *const writer_argv[] = {
        "/bin/sh", "-c", ": >begun; head -c 5M /dev/zero | tr '\\0' a; " UNTIL_GO "exit 1", NULL};
    SandboxCommand writer = shell_command("");
    writer.argv = writer_argv;
    SandboxCommand waiter = shell_command(": >begun; " UNTIL_GO "echo b; exit 2");
    mkdir("one", 0755);
    mkdir("two", 0755);
    writer.mounts[0].outside = "one";
    waiter.mounts[0].outside = "two";

    SandboxRun *first = sandbox_start(&writer);
    SandboxRun *second = sandbox_start(&waiter);
    cr_assert(first != NULL && second != NULL);
    file_await("one/begun");
    file_await("two/begun");
    file_write("one/go", "", 0);
    file_write("two/go", "", 0);
    SandboxResult second_result = sandbox_wait(second);
    SandboxResult first_result = sandbox_wait(first);
    cr_expect_str_eq(second_result.output, "b\n");
    cr_expect_eq(first_result.output[0], 'a');
    expect_exit(second_result, 2);
    expect_exit(first_result, 1);
}

// ---- Which sandbox works here? ---------------------------------------------------------------

TEST_EACH(choosing_is_silent_where_it_works)
{
    SandboxKind kind = SANDBOX_ANY;
    capture_begin(2);
    int status = sandbox_choose(tested_kind, &kind);
    cr_expect_str_eq(capture_end(2), "");
    cr_expect_eq(status, 0);
    cr_expect_eq(kind, tested_kind);
}

TEST_EACH(nothing_is_chosen_where_the_wanted_one_fails)
{
    SandboxKind kind = SANDBOX_ANY;
    setenv("PATH", "/nowhere", 1);
    setenv("TMPDIR", "/nowhere", 1);
    capture_begin(2);
    int status = sandbox_choose(tested_kind, &kind);
    expect_one_message(capture_end(2), tested_kind == SANDBOX_BUBBLEWRAP
                                           ? "sandbox: bwrap not found: install bubblewrap"
                                           : "sandbox: cannot make a folder in $TMPDIR or /tmp");
    cr_expect_eq(status, -1);
}

// What bubblewrap does where there are no namespaces for it.
static void failing_bubblewrap_install(void)
{
    const char *failing =
        "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n";
    file_write("bwrap", failing, strlen(failing));
    cr_assert_eq(chmod("bwrap", 0755), 0);
    setenv("PATH", surroundings_folder, 1);
}

Test(bubblewrap, choosing_says_what_to_do_where_it_fails)
{
    SandboxKind kind = SANDBOX_ANY;
    failing_bubblewrap_install();
    capture_begin(2);
    int status = sandbox_choose(SANDBOX_BUBBLEWRAP, &kind);
    const char *message = capture_end(2);
    cr_expect_not_null(strstr(message, "sandbox: bwrap: No permissions"), "%s", message);
    cr_expect_not_null(strstr(message, "kernel.unprivileged_userns_clone=1"), "%s", message);
    cr_expect_eq(status, -1);
}

Test(landlock, is_chosen_where_bubblewrap_fails)
{
    if (geteuid() != 0) {
        SKIP_TEST("this sandbox needs root");
    }
    SandboxKind kind = SANDBOX_ANY;
    failing_bubblewrap_install();
    capture_begin(2);
    int status = sandbox_choose(SANDBOX_ANY, &kind);
    expect_one_message(capture_end(2), "No permissions to create new namespace): Landlock is used");
    cr_expect_eq(status, 0);
    cr_expect_eq(kind, SANDBOX_LANDLOCK);
}

// In a process of its own, as an ordinary user cannot become root again.
static void expect_refusal_to_ordinary_user(void)
{
    SandboxKind kind = SANDBOX_ANY;
    if (geteuid() == 0) {
        cr_assert_eq(setresuid(65534, 65534, 65534), 0);
    }
    capture_begin(2);
    int status = sandbox_choose(tested_kind, &kind);
    expect_one_message(capture_end(2), "root");
    cr_expect_eq(status, -1);
    _exit(0);
}

Test(landlock, is_refused_to_an_ordinary_user)
{
    expect_refusal_to_ordinary_user();
}

Test(user, is_refused_to_an_ordinary_user)
{
    expect_refusal_to_ordinary_user();
}

Test(sandbox, none_is_never_chosen_by_itself)
{
    SandboxKind kind = SANDBOX_NONE;
    setenv("PATH", "/nowhere", 1);
    setenv("TMPDIR", "/nowhere", 1);
    capture_begin(2);
    int status = sandbox_choose(SANDBOX_ANY, &kind);
    capture_end(2);
    cr_expect_eq(status, -1);
    cr_expect_neq(kind, SANDBOX_NONE);
}
