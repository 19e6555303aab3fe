// grader/allowance: what a submission may use, from what the solution used.
#include "allowance.h"
#include "sandbox_clock.h"
#include "surroundings.h"

TestSuite(allowance, .init = folder_enter, .fini = folder_leave);

Test(allowance, a_solution_that_takes_long_gives_time_in_proportion)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5, .asleep = 3});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1);
    cr_expect_eq(time.processor, 30);
    cr_expect_eq(time.asleep, 18);
    cr_expect_geq(time.wall, 20 * time.processor);
}

Test(allowance, of_what_is_short_there_is_a_floor)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 0.1});
    const SandboxTime time = allowance_of(&allowance, STEP_COMPILING, 1);
    cr_expect_eq(time.processor, 5);
    cr_expect_eq(time.asleep, 5);
}

Test(allowance, while_nothing_is_known_all_is_as_for_ours)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 1});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, allowance_ours().processor);
    cr_expect_gt(allowance_ours().processor, 100);
}

Test(allowance, the_instructors_own_limit_wins)
{
    Allowance allowance = {.given_seconds = 2};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1);
    cr_expect_eq(time.processor, 2);
    cr_expect_eq(time.asleep, 2);
    cr_expect_geq(time.wall, 40);
}

// Where the whole did not end, an answer alone need not show it for as long again.
Test(allowance, what_is_known_to_loop_may_use_half)
{
    Allowance allowance = {.is_looping = 1};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 2});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1);
    cr_expect_eq(time.processor, 6);
    cr_expect_eq(time.asleep, 2.5);
    allowance.given_seconds = 3;
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, 3, "the instructor's wins");
}

// However it is shared out, one submission uses no more than its total.
Test(allowance, all_runs_of_one_submission_have_a_limit_together)
{
    Allowance allowance = {.is_for_one = 1};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1});
    cr_assert_eq(allowance_total(&allowance), 44);
    int n_runs = 0;
    double used = 0;
    for (; allowance_left(&allowance) > 0; n_runs++) {
        const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1);
        cr_assert_geq(time.processor, 1);
        allowance.spent += time.processor + time.asleep;
        used += time.processor + time.asleep;
    }
    cr_expect_eq(n_runs, 4);
    cr_expect_eq(used, 44);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, 1, "it can be killed");
}

// What hid for all of its wall time is tried no more.
Test(allowance, who_used_up_its_wall_time_has_nothing_left)
{
    Allowance allowance = {.is_for_one = 1};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1});
    SandboxResult result = {.outcome = SANDBOX_EXITED, .used = {.processor = 1, .wall = 300}};
    allowance_charge(&allowance, &result);
    cr_expect_eq(allowance_left(&allowance), 43);
    result.outcome = SANDBOX_OVERDUE;
    allowance_charge(&allowance, &result);
    cr_expect_leq(allowance_left(&allowance), 0);
}

Test(allowance, what_runs_side_by_side_shares_what_is_left)
{
    Allowance allowance = {.is_for_one = 1, .spent = 38};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, 6);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 2).processor, 3);
}

// The known answers of a lab go through one session.
Test(allowance, many_submissions_have_no_limit_together)
{
    Allowance allowance = {.spent = 10000};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1});
    cr_expect_gt(allowance_left(&allowance), 10000);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, 6);
}

Test(allowance, no_wall_time_goes_beyond_the_deadline)
{
    Allowance allowance = {.is_for_one = 1, .deadline = seconds_now() + 30};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1});
    cr_expect_leq(allowance_of(&allowance, STEP_RUNNING, 1).wall, 30);
    cr_expect_gt(allowance_of(&allowance, STEP_RUNNING, 1).wall, 20);
    cr_expect_eq(allowance_left(&allowance), 44);
    // Nothing new is begun that could not be done, but what runs may go on.
    allowance.deadline = seconds_now() + 2.5;
    cr_expect_eq(allowance_left(&allowance), 0);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).processor, 6);
    allowance.deadline = seconds_now() - 1;
    cr_expect_eq(allowance_left(&allowance), 0);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1).wall, 1);
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
        cr_expect_eq(allowance_of(&allowance, step, 1).processor, 16);
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
