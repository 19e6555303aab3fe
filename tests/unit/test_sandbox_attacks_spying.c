// grader/sandbox: attacks that read what is not theirs or reach other processes, behind every kind
// of walls.
#include "limited_folder.h"
#include "sandbox_commands.h"

#include <glob.h>

// ---- What must not be read ----------------------------------------------------------------------

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

// ---- Other processes ----------------------------------------------------------------------------

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
