// grader/sandbox: how a command is stopped when its time is over, and how its end is told.
#include "sandbox_commands.h"

#include <sched.h>
#include <sys/prctl.h>

// ---- Time ---------------------------------------------------------------------------------------

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

// What it may use is found out when it has used a part of it (allowance.h).
TEST_EACH(what_it_used_is_told_and_what_is_allowed_can_change_while_it_runs)
{
    const struct timespec pause = {.tv_nsec = 10000000};
    SandboxCommand command = shell_command("while :; do :; done");
    command.time = (SandboxTime){600, 600, 6000};
    SandboxRun *run = sandbox_start(&command);
    cr_assert_not_null(run);
    while (sandbox_used(run).processor < 0.1 && !sandbox_has_ended(run)) {
        nanosleep(&pause, NULL);
    }
    cr_expect_not(sandbox_has_ended(run));
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

// The number of the processor that this test is on first.
static int first_processor(void)
{
    cpu_set_t all;
    int cpu = 0;
    cr_assert_eq(sched_getaffinity(0, sizeof all, &all), 0);
    while (!CPU_ISSET(cpu, &all)) {
        cpu++;
    }
    return cpu;
}

// Stay on that processor, and all that is started from here on. A run cannot choose its own.
static void stay_there(void)
{
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first_processor(), &one);
    cr_assert_eq(sched_setaffinity(0, sizeof one, &one), 0);
}

// Loops of nobody's run, each a session of its own: the kernel may share processors out by those.
static void others_start(pid_t others[], int n)
{
    for (int i = 0; i < n; i++) {
        others[i] = fork();
        if (others[i] == 0) {
            setsid();
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            for (;;) {
            }
        }
    }
}

TEST_EACH(who_was_kept_waiting_for_a_processor_was_starved)
{
    // Five loops on one processor, of which one is the run's: it waits four fifths of the time.
    enum { N_OTHERS = 4 };
    pid_t others[N_OTHERS];
    stay_there();
    others_start(others, N_OTHERS);
    SandboxCommand command = shell_command("while :; do :; done");
    command.time = (SandboxTime){.processor = 600, .asleep = 600, .wall = 3};
    expect_end(&command, SANDBOX_STARVED);
    for (int i = 0; i < N_OTHERS; i++) {
        kill(others[i], SIGKILL);
        waitpid(others[i], NULL, 0);
    }
}

TEST_EACH(who_waits_for_its_brother_is_stopped)
{
    // In vfork()'s state, but what it waits for is its own brother: the filter knows the call.
    SandboxCommand command = shell_command(
        "echo '#define _GNU_SOURCE\n#include <sched.h>\n#include <signal.h>\n#include <unistd.h>\n"
        "static char stack[65536]; int pause_on(void *a) { for (;;) pause(); }\n"
        "int main(void) { clone(pause_on, stack + 65536, CLONE_VM | CLONE_VFORK | CLONE_PARENT |"
        " SIGCHLD, 0); }' >v.c\ngcc -w v.c -o v && exec ./v");
    command.time = (SandboxTime){.processor = 600, .asleep = 600, .wall = 3};
    expect_end(&command, SANDBOX_FORBIDDEN);
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

// ---- The end ------------------------------------------------------------------------------------

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
    expect_one_message(capture_end(2), "sandbox: absent \\x1B[2J: No such file");
    cr_expect_null(run);
}
