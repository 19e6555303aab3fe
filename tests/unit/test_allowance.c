// grader/allowance: what a submission may use, from what the solution used.
#include "allowance.h"
#include "sandbox_clock.h"

#include <criterion/criterion.h>

TestSuite(allowance);

Test(allowance, a_solution_that_takes_long_gives_time_in_proportion)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5, .asleep = 3});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 0);
    cr_expect_eq(time.processor, 20);
    cr_expect_eq(time.asleep, 12);
    cr_expect_geq(time.wall, 20 * time.processor);
}

Test(allowance, of_what_is_short_there_is_a_floor)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 0.1});
    const SandboxTime time = allowance_of(&allowance, STEP_COMPILING, 1, 0);
    cr_expect_eq(time.processor, 5);
    cr_expect_eq(time.asleep, 5);
}

Test(allowance, while_nothing_is_known_all_is_as_for_ours)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_COMPILING, (SandboxTime){.processor = 1});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).processor,
                 allowance_ours().processor);
    cr_expect_gt(allowance_ours().processor, 100);
}

Test(allowance, the_instructors_own_limit_wins)
{
    Allowance allowance = {.given_seconds = 2};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 5});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 0);
    cr_expect_eq(time.processor, 2);
    cr_expect_eq(time.asleep, 2);
    cr_expect_geq(time.wall, 40);
}

// An endless loop that the whole met need not be watched for as long again.
Test(allowance, what_may_loop_again_has_a_small_limit_of_its_own)
{
    Allowance allowance = {0};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 2});
    const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 1);
    cr_expect_eq(time.processor, 5);
    cr_expect_eq(time.asleep, 2.5);
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 0.1});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 1).processor, 2.5);
    allowance.given_seconds = 3;
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 1).processor, 3,
                 "the instructor's wins");
}

// Where the solution is not here, nobody waits for what runs in its place until that is needed.
Test(allowance, what_takes_long_asks_what_it_may_use)
{
    struct Variant *const handed_out = (struct Variant *)&(char){0};
    Allowance allowance = {.yardstick = handed_out};
    cr_expect_not(allowance_is_asked(&allowance, (SandboxTime){.processor = 2}));
    cr_expect(allowance_is_asked(&allowance, (SandboxTime){.processor = 2.5}));
    cr_expect(allowance_is_asked(&allowance, (SandboxTime){.asleep = 2.5}));
    allowance.given_seconds = 20;
    cr_expect_not(allowance_is_asked(&allowance, (SandboxTime){.processor = 9}), "it is given");
    allowance = (Allowance){0};
    cr_expect_not(allowance_is_asked(&allowance, (SandboxTime){.processor = 9}), "it has run");
    allowance = (Allowance){.yardstick = handed_out, .deadline = seconds_now() + 2};
    cr_expect_not(allowance_is_asked(&allowance, (SandboxTime){.processor = 9}), "it is too late");
}

// However it is shared out, one submission uses no more than its total.
Test(allowance, all_runs_of_one_submission_have_a_limit_together)
{
    Allowance allowance = {.is_for_one = 1};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1.5});
    cr_assert_eq(allowance_total(&allowance), 44);
    int n_runs = 0;
    double used = 0;
    for (; allowance_left(&allowance) > 0; n_runs++) {
        const SandboxTime time = allowance_of(&allowance, STEP_RUNNING, 1, 0);
        cr_assert_geq(time.processor, 1);
        allowance.spent += time.processor + time.asleep;
        used += time.processor + time.asleep;
    }
    cr_expect_eq(n_runs, 4);
    cr_expect_eq(used, 44);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).processor, 1, "it can be killed");
}

// What hid for all of its wall time is tried no more.
Test(allowance, who_used_up_its_wall_time_has_nothing_left)
{
    Allowance allowance = {.is_for_one = 1};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1.5});
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
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1.5});
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).processor, 6);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 2, 0).processor, 3);
}

// The known answers of a lab go through one session.
Test(allowance, many_submissions_have_no_limit_together)
{
    Allowance allowance = {.spent = 10000};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1.5});
    cr_expect_gt(allowance_left(&allowance), 10000);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).processor, 6);
}

Test(allowance, no_wall_time_goes_beyond_the_deadline)
{
    Allowance allowance = {.is_for_one = 1, .deadline = seconds_now() + 30};
    allowance_note(&allowance, STEP_RUNNING, (SandboxTime){.processor = 1.5});
    cr_expect_leq(allowance_of(&allowance, STEP_RUNNING, 1, 0).wall, 30);
    cr_expect_gt(allowance_of(&allowance, STEP_RUNNING, 1, 0).wall, 20);
    cr_expect_eq(allowance_left(&allowance), 44);
    // Nothing new is begun that could not be done, but what runs may go on.
    allowance.deadline = seconds_now() + 2.5;
    cr_expect_eq(allowance_left(&allowance), 0);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).processor, 6);
    allowance.deadline = seconds_now() - 1;
    cr_expect_eq(allowance_left(&allowance), 0);
    cr_expect_eq(allowance_of(&allowance, STEP_RUNNING, 1, 0).wall, 1);
}
