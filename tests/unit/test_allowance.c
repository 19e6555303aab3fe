// grader/allowance: what a submission may use, from what the solution used.
#include "allowance.h"
#include "surroundings.h"

TestSuite(allowance, .init = folder_enter, .fini = folder_leave);

Test(allowance, a_solution_that_takes_long_gives_time_in_proportion)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5, .asleep = 3});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING);
    cr_expect_eq(time.processor, 40);
    cr_expect_eq(time.asleep, 24);
    cr_expect_geq(time.wall, 20 * time.processor);
}

Test(allowance, of_what_is_short_there_is_a_floor)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 0.1});
    const SandboxTime time = allowance_of(&allowance, STEP_COMPILING);
    cr_expect_eq(time.processor, 10);
    cr_expect_eq(time.asleep, 10);
}

Test(allowance, while_nothing_is_known_all_is_as_for_ours)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 1});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING).processor, allowance_ours().processor);
    cr_expect_gt(allowance_ours().processor, 100);
}

Test(allowance, the_instructors_own_limit_wins)
{
    Allowance allowance = {.given_seconds = 2};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING);
    cr_expect_eq(time.processor, 2);
    cr_expect_eq(time.asleep, 2);
    cr_expect_geq(time.wall, 40);
}

// Write what a handout holds.
static void pack(const char *text)
{
    cr_assert_eq(mkdir("tests", 0777), 0);
    file_write(SOLUTION_SECONDS_PATH, text, strlen(text));
}

Test(allowance, a_handout_knows_what_the_solution_took)
{
    Allowance allowance = {0};
    pack("4\n");
    cr_assert_eq(allowance_read_packed(&allowance), 0);
    for (Step step = 0; step < N_STEPS; step++) {
        cr_expect_eq(allowance_of(&allowance, step).processor, 16);
    }
}

static const char *const BAD[] = {"", "0", "4.5", "four", "-1", "100000"};

Test(allowance, a_handout_that_does_not_is_a_fault_with_one_message)
{
    Allowance allowance = {0};
    capture_begin(2);
    cr_expect_eq(allowance_read_packed(&allowance), -1);
    expect_one_message(capture_end(2), SOLUTION_SECONDS_PATH);
    pack("");
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++) {
        file_write(SOLUTION_SECONDS_PATH, BAD[i], strlen(BAD[i]));
        capture_begin(2);
        cr_expect_eq(allowance_read_packed(&allowance), -1, "\"%s\"", BAD[i]);
        expect_one_message(capture_end(2), "expected whole seconds");
    }
}
