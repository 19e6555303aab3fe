// grader/sandbox: what a command inside can reach, how it is stopped, and how its end is told.
//
// The commands are small shell scripts, each bounded by itself: where a wall of the sandbox were
// missing, the test would fail and the machine stay well. Where something must be out of reach, the
// test first makes sure that it is there to be reached.
#include "sandbox.h"
#include "surroundings.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>

enum { MAX_FILE_MB = 8, MAX_MEMORY_MB = 256, MAX_PROCESSES = 24 };

// A folder that the sandboxed user owns.
static void folder_hand_over(const char *path)
{
    cr_assert_eq(chmod(path, 0755), 0);
}

static void sandbox_folder_enter(void)
{
    SandboxKind kind;
    cr_assert_eq(sandbox_choose(SANDBOX_ANY, &kind), 0, "nothing can be sandboxed here");
    folder_enter();
    folder_hand_over(".");
}

TestSuite(sandbox, .init = sandbox_folder_enter, .fini = folder_leave, .timeout = 60);

// `script` in a shell, with the current folder as /work. One command at a time in a process.
static SandboxCommand shell_command(const char *script)
{
    static const char *argv[] = {"/bin/sh", "-c", NULL, NULL};
    argv[2] = script;
    return (SandboxCommand){
        .argv = argv,
        .folder = "/work",
        .mounts = {{.outside = ".", .inside = "/work", .writable = 1}},
        .n_mounts = 1,
        .wall_seconds = 20,
        .cpu_seconds = 10,
        .memory_mb = MAX_MEMORY_MB,
        .file_mb = MAX_FILE_MB,
        .n_processes = MAX_PROCESSES,
    };
}

static SandboxResult command_run(const SandboxCommand *command)
{
    SandboxRun *run = sandbox_start(command);
    cr_assert_not_null(run);
    SandboxResult result = sandbox_wait(run);
    cr_assert_not_null(result.output);
    return result;
}

static SandboxResult shell_run(const char *script)
{
    SandboxCommand command = shell_command(script);
    return command_run(&command);
}

static void expect_exit(SandboxResult result, int exit_status)
{
    cr_expect_eq(result.outcome, SANDBOX_EXITED, "outcome %d, signal %d: %s", result.outcome,
                 result.signal, result.output);
    cr_expect_eq(result.exit_status, exit_status, "exit status %d: %s", result.exit_status,
                 result.output);
    free(result.output);
}

static void expect_crash(SandboxResult result, int signal_id)
{
    cr_expect_eq(result.outcome, SANDBOX_CRASHED, "outcome %d, exit status %d: %s", result.outcome,
                 result.exit_status, result.output);
    cr_expect_eq(result.signal, signal_id, "signal %d", result.signal);
    free(result.output);
}

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void sleep_milliseconds(long milliseconds)
{
    nanosleep(&(struct timespec){milliseconds / 1000, milliseconds % 1000 * 1000000}, NULL);
}

// ---- Out of reach ----------------------------------------------------------------------------

static int exit_status_outside(const char *script)
{
    int status = system(script);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Test(sandbox, the_network_is_unreachable_even_on_this_machine)
{
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t n_bytes = sizeof address;
    cr_assert_eq(bind(listener, (struct sockaddr *)&address, n_bytes), 0);
    cr_assert_eq(listen(listener, 4), 0);
    cr_assert_eq(getsockname(listener, (struct sockaddr *)&address, &n_bytes), 0);

    char script[128];
    snprintf(script, sizeof script, "bash -c 'exec 3<>/dev/tcp/127.0.0.1/%d' 2>/dev/null",
             ntohs(address.sin_port));
    cr_assert_eq(exit_status_outside(script), 0);
    expect_exit(shell_run(script), 1);
    close(listener);
}

Test(sandbox, the_hosts_secrets_and_homes_are_not_there)
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

// Processes that a test looks for sleep for a time that no other process sleeps for: 1 minute and a
// fraction that is this process's own.
static const char *minute_sleep(const char *before, const char *after)
{
    static char script[256];
    snprintf(script, sizeof script, "%s sleep 60.%d %s", before, (int)getpid(), after);
    return script;
}

// Finds them. The dot in brackets keeps grep from finding its own arguments.
static const char *minute_sleep_search(void)
{
    static char script[64];
    snprintf(script, sizeof script, "grep -aqs 'sleep.60[.]%d' /proc/[0-9]*/cmdline",
             (int)getpid());
    return script;
}

static int minute_sleep_exists(void)
{
    return exit_status_outside(minute_sleep_search()) == 0;
}

// Wait until it is there, or is not; two seconds at most.
static int minute_sleep_becomes(int is_there)
{
    for (int i = 0; i < 100 && minute_sleep_exists() != is_there; i++) {
        sleep_milliseconds(20);
    }
    return minute_sleep_exists() == is_there;
}

Test(sandbox, other_processes_are_not_visible)
{
    pid_t sleeper = fork();
    if (sleeper == 0) {
        char seconds[32];
        snprintf(seconds, sizeof seconds, "60.%d", (int)getppid());
        execl("/bin/sleep", "sleep", seconds, NULL);
        _exit(1);
    }
    cr_assert(minute_sleep_becomes(1));
    expect_exit(shell_run(minute_sleep_search()), 1);
    kill(sleeper, SIGKILL);
    waitpid(sleeper, NULL, 0);
}

Test(sandbox, nothing_but_writable_mounts_can_be_written)
{
    cr_assert_eq(mkdir("given", 0755), 0);
    folder_hand_over("given");
    file_write("given/own", "x", 1);
    cr_assert_eq(chmod("given/own", 0666), 0);
    SandboxCommand command = shell_command(
        "for file in /x /usr/x /usr/bin/x /etc/x /etc/OpenCL/x /dev/x /sys/x /given/x /given/own\n"
        "do (echo x >$file) 2>/dev/null && echo $file; done\n"
        "echo x >/tmp/x && echo x >/dev/shm/x && echo x >/work/x");
    command.mounts[1] = (SandboxMount){.outside = "given", .inside = "/given"};
    command.n_mounts = 2;
    SandboxResult result = command_run(&command);
    cr_expect_str_eq(result.output, "", "written: %s", result.output);
    expect_exit(result, 0);
    cr_expect_eq(access("x", F_OK), 0, "the writable mount was not written");
    cr_expect_neq(access("given/x", F_OK), 0);
}

Test(sandbox, runs_as_an_ordinary_user_without_rights)
{
    char expected[128];
    snprintf(expected, sizeof expected, "%u\n0000000000000000\n", sandbox_user());
    SandboxResult result = shell_run(
        "id -u; sed -n 's/CapEff:[^0-9a-f]*//p' /proc/self/status; unshare --user true 2>/dev/null "
        "&& echo became root of a namespace");
    cr_expect_str_eq(result.output, expected, "%s", result.output);
    cr_expect_neq(sandbox_user(), 0);
    free(result.output);
}

Test(sandbox, the_graders_environment_and_open_files_stay_outside)
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
    cr_expect_not_null(strstr(result.output, "HOME is /tmp, SEED is a b=c\n"), "%s", result.output);
    expect_exit(result, 2);  // of ls: no such descriptor
}

// ---- Limits ----------------------------------------------------------------------------------

Test(sandbox, a_file_over_its_limit_is_stopped)
{
    expect_crash(shell_run("exec head -c 40M /dev/zero >large"), SIGXFSZ);
    struct stat status;
    cr_assert_eq(stat("large", &status), 0);
    cr_expect_eq(status.st_size, MAX_FILE_MB * 1024 * 1024);
}

Test(sandbox, its_folders_in_memory_are_bounded)
{
    SandboxResult result = shell_run("for folder in /tmp /dev/shm; do for i in $(seq 40); do\n"
                                     "head -c 8M /dev/zero >$folder/$i || break; done; done 2>&1\n"
                                     "du -sm /tmp /dev/shm");
    cr_expect_not_null(strstr(result.output, "256\t/tmp\n64\t/dev/shm\n"), "%s", result.output);
    free(result.output);
}

Test(sandbox, a_memory_hog_is_stopped)
{
    // dd takes its block from memory at once: within the limit, and beyond it.
    expect_exit(shell_run("dd if=/dev/zero of=/dev/null bs=100M count=1 2>/dev/null"), 0);
    expect_exit(shell_run("dd if=/dev/zero of=/dev/null bs=600M count=1 2>/dev/null"), 1);
}

Test(sandbox, a_burst_of_processes_is_stopped)
{
    SandboxResult result =
        shell_run("for i in $(seq 60); do sleep 2 & echo $i; done 2>/dev/null; echo all");
    cr_expect_null(strstr(result.output, "all"), "%s", result.output);
    cr_expect_not_null(strstr(result.output, "\n20\n"), "stopped too early: %s", result.output);
    cr_expect_null(strstr(result.output, "\n24\n"), "%s", result.output);
    free(result.output);
}

Test(sandbox, processes_outside_do_not_count)
{
    // Another run takes almost all that it may; this one has its own count.
    SandboxCommand command = shell_command("for i in $(seq 20); do sleep 1 & done; wait");
    SandboxRun *first = sandbox_start(&command);
    SandboxResult second = command_run(&command);
    SandboxResult result = sandbox_wait(first);
    expect_exit(second, 0);
    expect_exit(result, 0);
}

// Run, and see it end as timed out within these times.
static void expect_time_out(const SandboxCommand *command, double min_seconds, double max_seconds)
{
    double start = seconds_now();
    SandboxResult result = command_run(command);
    double seconds = seconds_now() - start;
    cr_expect_eq(result.outcome, SANDBOX_TIMED_OUT, "outcome %d: %s", result.outcome,
                 result.output);
    cr_expect(seconds >= min_seconds && seconds <= max_seconds, "took %.2f s", seconds);
    free(result.output);
}

Test(sandbox, an_endless_loop_ends_at_the_cpu_limit)
{
    SandboxCommand command = shell_command("while :; do :; done");
    command.cpu_seconds = 1;
    expect_time_out(&command, 0.9, 10);
}

Test(sandbox, a_handler_of_sigxcpu_wins_nothing)
{
    SandboxCommand command = shell_command("trap '' XCPU TERM INT; while :; do :; done");
    command.cpu_seconds = 1;
    expect_time_out(&command, 0.9, 10);
}

Test(sandbox, a_sleeper_ends_at_the_wall_limit)
{
    SandboxCommand command = shell_command("echo begun; sleep 30");
    command.wall_seconds = 1;
    expect_time_out(&command, 0.9, 4);
}

Test(sandbox, closing_the_output_does_not_hide_a_sleeper)
{
    SandboxCommand command = shell_command("exec >/dev/null 2>&1; sleep 30");
    command.wall_seconds = 1;
    expect_time_out(&command, 0.9, 4);
}

Test(sandbox, the_wall_limit_holds_without_anybody_waiting)
{
    SandboxCommand command = shell_command("sleep 2; echo x >late");
    command.wall_seconds = 1;
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    sleep_milliseconds(3000);
    cr_expect_neq(access("late", F_OK), 0);
    SandboxResult result = sandbox_wait(run);
    cr_expect_eq(result.outcome, SANDBOX_TIMED_OUT);
    free(result.output);
}

// ---- The end ---------------------------------------------------------------------------------

Test(sandbox, a_background_process_is_gone_when_the_command_ends)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", "& sleep 1; exit 4"));
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    cr_assert(minute_sleep_becomes(1), "the test sees no processes inside");
    expect_exit(sandbox_wait(run), 4);
    cr_expect_not(minute_sleep_exists());
}

Test(sandbox, a_background_process_is_gone_after_a_time_out)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", ">/dev/null 2>&1 & sleep 30"));
    command.wall_seconds = 1;
    expect_time_out(&command, 0.9, 4);
    cr_expect_not(minute_sleep_exists());
}

Test(sandbox, everything_is_gone_when_the_grader_is_killed)
{
    SandboxCommand command = shell_command(minute_sleep("setsid", "& sleep 30"));
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

Test(sandbox, exit_codes_and_signals_are_told_apart)
{
    expect_exit(shell_run("exit 0"), 0);
    expect_exit(shell_run("exit 3"), 3);
    expect_exit(shell_run("exit 255"), 255);
    expect_crash(shell_run("kill -SEGV $$"), SIGSEGV);
    expect_crash(shell_run("kill -ABRT $$"), SIGABRT);
    expect_crash(shell_run("kill -KILL $$"), SIGKILL);  // but no time-out
}

Test(sandbox, a_command_cannot_pass_for_a_fault_of_the_sandbox)
{
    // What the kernel refuses to execute: no interpreter, no permission, no file.
    file_write("program", "#!/absent\n", 10);
    cr_assert_eq(chmod("program", 0755), 0);
    SandboxCommand command = shell_command("");
    command.argv = (const char *const[]){"/work/program", NULL};
    expect_exit(command_run(&command), 127);
    cr_assert_eq(chmod("program", 0644), 0);
    expect_exit(command_run(&command), 126);
    command.argv = (const char *const[]){"/work/absent", NULL};
    expect_exit(command_run(&command), 127);
    expect_exit(shell_run("echo 'bwrap: no'; kill -KILL 1; kill -KILL -1; exit 1"), 1);
}

Test(sandbox, a_sandbox_that_cannot_be_made_is_a_fault)
{
    SandboxCommand command = shell_command("exit 0");
    command.mounts[0].inside = "/usr/bin/true/work";
    SandboxResult result = command_run(&command);
    cr_expect_eq(result.outcome, SANDBOX_FAULT);
    cr_expect_not_null(strstr(result.output, "bwrap: "), "%s", result.output);
    free(result.output);
}

Test(sandbox, an_absent_mount_is_told_at_the_start)
{
    SandboxCommand command = shell_command("exit 0");
    command.mounts[0].outside = "absent";
    capture_begin(2);
    SandboxRun *run = sandbox_start(&command);
    expect_one_message(capture_end(2), "absent");
    cr_expect_null(run);
}

// ---- Output ----------------------------------------------------------------------------------

Test(sandbox, output_is_kept_up_to_a_bound_and_read_to_the_end)
{
    double start = seconds_now();
    SandboxResult result = shell_run("head -c 50M /dev/zero | tr '\\0' x; echo end >&2; exit 5");
    cr_expect_lt(seconds_now() - start, 15);
    cr_expect_eq(strlen(result.output), SANDBOX_MAX_OUTPUT);
    cr_expect_eq(strspn(result.output, "x"), SANDBOX_MAX_OUTPUT);
    expect_exit(result, 5);
}

Test(sandbox, control_characters_are_replaced)
{
    SandboxResult result =
        shell_run("printf 'a\\tb\\033[2Jc\\000d\\r\\177\\303\\244\\n'; printf e >&2");
    cr_expect_str_eq(result.output, "a\tb?[2Jc?d??\303\244\ne", "%s", result.output);
    expect_exit(result, 0);
}

Test(sandbox, two_run_at_the_same_time_and_end_in_any_order)
{
    const char *const writer_argv[] = {"/bin/sh", "-c",
                                       "head -c 5M /dev/zero | tr '\\0' a; sleep 1; exit 1", NULL};
    SandboxCommand writer = shell_command("");
    writer.argv = writer_argv;
    SandboxCommand sleeper = shell_command("sleep 1; echo b; exit 2");

    double start = seconds_now();
    SandboxRun *first = sandbox_start(&writer);
    SandboxRun *second = sandbox_start(&sleeper);
    cr_assert(first != NULL && second != NULL);
    SandboxResult second_result = sandbox_wait(second);
    SandboxResult first_result = sandbox_wait(first);
    cr_expect_lt(seconds_now() - start, 1.9);
    cr_expect_str_eq(second_result.output, "b\n");
    cr_expect_eq(first_result.output[0], 'a');
    expect_exit(second_result, 2);
    expect_exit(first_result, 1);
}

// ---- Can anything be sandboxed here? ---------------------------------------------------------

Test(sandbox, check_is_silent_where_it_works)
{
    capture_begin(2);
    SandboxKind kind;
    int status = sandbox_choose(SANDBOX_BUBBLEWRAP, &kind);
    cr_expect_str_eq(capture_end(2), "");
    cr_expect_eq(status, 0);
}

Test(sandbox, check_names_the_missing_program)
{
    setenv("PATH", "/nowhere", 1);
    capture_begin(2);
    SandboxKind kind;
    int status = sandbox_choose(SANDBOX_BUBBLEWRAP, &kind);
    const char *message = capture_end(2);
    cr_expect_str_eq(message, "sandbox: bwrap not found: install bubblewrap\n", "%s", message);
    cr_expect_eq(status, -1);
}

Test(sandbox, check_says_what_to_do_where_bubblewrap_fails)
{
    const char *failing =
        "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n";
    file_write("bwrap", failing, strlen(failing));
    cr_assert_eq(chmod("bwrap", 0755), 0);
    setenv("PATH", surroundings_folder, 1);
    capture_begin(2);
    SandboxKind kind;
    int status = sandbox_choose(SANDBOX_BUBBLEWRAP, &kind);
    const char *message = capture_end(2);
    cr_expect_not_null(strstr(message, "sandbox: bwrap: No permissions"), "%s", message);
    cr_expect_not_null(strstr(message, "kernel.unprivileged_userns_clone=1"), "%s", message);
    cr_expect_eq(status, -1);
}
