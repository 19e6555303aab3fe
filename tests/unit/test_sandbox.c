// grader/sandbox: what a command inside can reach, how much it may take and what comes out of it,
// the same behind every kind of walls. Attacks stand in test_sandbox_attacks_*.c.
#include "sandbox_commands.h"

#include <fcntl.h>

// ---- Out of reach -------------------------------------------------------------------------------

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

// In every one of these folders somebody has files, here or elsewhere.
TEST_BOTH(the_hosts_folders_cannot_be_read)
{
    SandboxResult result =
        shell_run("for folder in /root /home /var /run /boot /mnt /srv /opt /tmp; do\n"
                  "    ls $folder >x 2>x-error && [ -s x ] && echo $folder; done\n"
                  "for file in /etc/shadow /etc/passwd /etc/hostname /etc/hosts;\n"
                  "    do head -c 1 $file >x 2>x-error && [ -s x ] && echo $file; done; true");
    cr_expect_str_eq(result.output, "", "read: %s", result.output);
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

TEST_EACH(what_it_prints_names_no_folder_of_this_machine)
{
    SandboxResult result = shell_run("echo $HOME, $TMPDIR/file:1, /work");
    cr_expect_str_eq(result.output, "/tmp, /tmp/file:1, /work\n");
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

// ---- Limits -------------------------------------------------------------------------------------

TEST_EACH(a_file_over_its_limit_is_stopped)
{
    expect_crash(shell_run("exec head -c 40M /dev/zero >large"), SIGXFSZ);
    struct stat status;
    cr_assert_eq(stat("large", &status), 0);
    cr_expect_eq(status.st_size, MAX_FILE_MB * 1024 * 1024);
}

// Behind Landlock they are folders on a disk, which the scan counts.
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
    // Another run takes almost all that it may; this one has its own count. The shell's own `wait`
    // needs a handler of SIGCHLD, which the filter refuses.
    SandboxCommand command = shell_command("for i in $(seq 20); do sleep 1 & done; sleep 3");
    cr_assert_eq(mkdir("first", 0755) | mkdir("second", 0755), 0);
    command.mounts[0].outside = "first";  // a writable mount is one run's at a time
    SandboxRun *first = sandbox_start(&command);
    command.mounts[0].outside = "second";
    SandboxResult second = command_run(&command);
    SandboxResult result = sandbox_wait(first);
    expect_exit(second, 0);
    expect_exit(result, 0);
}

// ---- Output -------------------------------------------------------------------------------------

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
