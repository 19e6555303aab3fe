// grader/blame: a check of the whole that another task's answer fails names that task, and neither
// a cause nor a hint of its own.
#include "blame.h"

#include "hints.h"
#include "message.h"

#include <criterion/criterion.h>

TestSuite(blame);

static const Check checks[] = {
    {"leaf-ids", "Whose hit it is", "search_leaf", 40, NULL, 0, 0},
    {"trace-own", "The way down", "trace", 20, NULL, 0, 0},
    {"trace-picture", "Whole pictures", "trace", 40, "*", 0, 0},
};

static const Manifest manifest = {
    .lab = "07",
    .n_tasks = 2,
    .tasks = {{.id = "search_leaf", .hint = "Write down the ids."},
              {.id = "trace", .hint = "Play with cards."}},
};

// A result in which the checks have these statuses, and the same was found in each: `looks`, where
// it is not NULL, is its cause.
static Result result_of(const CheckStatus statuses[3], const char *looks)
{
    Result result = {.n_checks = 3};
    for (int i = 0; i < 3; i++) {
        result.checks[i] = (CheckResult){.id = checks[i].id,
                                         .task = checks[i].task,
                                         .status = statuses[i],
                                         .is_explained = looks != NULL};
        check_tell(&result.checks[i],
                   diagnosis_of(message_new("found 1, expected 2"),
                                (Cause){looks, looks ? MISTAKE_MIRRORED_X : MISTAKE_NONE}));
    }
    return result;
}

Test(blame, what_was_not_tried_alone_waits_for_the_task_at_fault)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    blame_others(checks, &result);
    cr_expect_eq(result.checks[2].status, CHECK_NOT_RUN);
    cr_expect_str_eq(result.checks[2].message,
                     "waits for search_leaf, which it needs and which is wrong: without its marker "
                     "lines it cannot be tried alone");
    cr_expect_str_eq(result.checks[0].message, "found 1, expected 2; it looks mirrored");
    result_free(&result);
}

// Its own mistake is its own: another wrong answer is no reason to wait with it.
Test(blame, what_fails_alone_too_is_told_so_and_what_else_may_be_in_the_facts)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    result.checks[2].is_own = 1;
    result.checks[2].alone = "it also fails when tested alone";
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[2].message,
                     "found 1, expected 2; it also fails when tested alone; search_leaf is wrong, "
                     "too, and may have a part in what was found");
    result_free(&result);
}

// It is wrong for certain, but of what was found another answer may be the cause.
Test(blame, what_fails_alone_stays_a_failure_without_a_cause)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    result.checks[2].is_own = 1;
    blame_others(checks, &result);
    cr_expect_eq(result.checks[2].status, CHECK_FAILED);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    cr_expect_str_eq(task_hint(&manifest, &result, &manifest.tasks[1]), "Play with cards.");
    cr_expect_eq(result.checks[2].diagnosis.mistake, MISTAKE_NONE, "what the cause named");
    result_free(&result);
}

// Alone it is right: then what is wrong beside it has a part in what was found.
Test(blame, what_passes_alone_names_the_one_answer_that_is_wrong)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    result.checks[2].is_own = result.checks[2].passes_alone = 1;
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2; alone it passes: search_leaf "
                                               "is wrong, and has a part in this");
    result_free(&result);
}

// Of two wrong answers nobody knows which one it is.
Test(blame, what_passes_alone_names_none_of_two)
{
    static const Check three[] = {
        {"leaf-ids", "Whose hit it is", "search_leaf", 40, NULL, 0, 0},
        {"clip", "The box", "clip_to_box", 20, NULL, 0, 0},
        {"trace-picture", "Whole pictures", "trace", 40, "*", 0, 0},
    };
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_FAILED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    result.checks[1].task = "clip_to_box";
    result.checks[2].is_own = result.checks[2].passes_alone = 1;
    blame_others(three, &result);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    result_free(&result);
}

// What nobody wrote is a fact, whoever has a part in it, and so are pixels.
Test(blame, what_the_facts_name_stays)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, NULL);
    result.checks[2].is_own = 1;
    result.checks[2].diagnosis.mistake = MISTAKE_UNWRITTEN;
    result.checks[2].diagnosis.evidence = EVIDENCE_PICTURE;
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    cr_expect_eq(result.checks[2].diagnosis.mistake, MISTAKE_UNWRITTEN);
    cr_expect_eq(result.checks[2].diagnosis.evidence, EVIDENCE_PICTURE);
    result_free(&result);
}

// What nobody wrote yet waits for nothing.
Test(blame, what_is_not_answered_does_not_wait)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, NULL);
    result.checks[2].diagnosis.silence = SILENCE_UNANSWERED;
    blame_others(checks, &result);
    cr_expect_eq(result.checks[2].status, CHECK_FAILED);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    result_free(&result);
}

// A task that a check does not need is no cause of it.
Test(blame, only_what_is_needed_is_blamed)
{
    static const Check rays[] = {
        {"axes", "The axes", "camera_axes", 40, NULL, 0, 0},
        {"color", "Colours", "direction_color", 60, "primary_ray pixel_on_display", 0, 0},
        {"pixel", "Pixels", "pixel_on_display", 60, "", 0, 0},
    };
    const CheckStatus first[] = {CHECK_FAILED, CHECK_FAILED, CHECK_PASSED};
    Result result = result_of(first, NULL);
    blame_others(rays, &result);
    cr_expect_eq(result.checks[1].status, CHECK_FAILED);
    result_free(&result);
    const CheckStatus last[] = {CHECK_FAILED, CHECK_FAILED, CHECK_FAILED};
    result = result_of(last, NULL);
    blame_others(rays, &result);
    cr_expect_str_eq(result.checks[1].message,
                     "waits for pixel_on_display, which it needs and which is wrong: without its "
                     "marker lines it cannot be tried alone");
    result_free(&result);
}

// Of two that need each other, the one that fails alone is at fault.
Test(blame, what_fails_alone_is_at_fault_for_certain)
{
    static const Check pictures[] = {
        {"picture", "Pictures", "descent", 50, "*", 0, 0},
        {"leaf", "Leaves", "leaf_loop", 50, "*", 0, 0},
        {"child", "Children", "getContainingChild", 0, NULL, 0, 0},
    };
    const CheckStatus both[] = {CHECK_FAILED, CHECK_FAILED, CHECK_PASSED};
    Result result = result_of(both, NULL);
    result.checks[1].is_own = 1;
    blame_others(pictures, &result);
    cr_expect_str_eq(result.checks[0].message,
                     "waits for leaf_loop, which it needs and which is wrong: without its marker "
                     "lines it cannot be tried alone");
    cr_expect_str_eq(result.checks[1].message, "found 1, expected 2");
    result_free(&result);
}

Test(blame, hints_follow_the_task_at_fault)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, NULL);
    blame_others(checks, &result);
    cr_expect_str_eq(task_hint(&manifest, &result, &manifest.tasks[0]), "Write down the ids.");
    cr_expect_str_eq(task_hint(&manifest, &result, &manifest.tasks[1]), "");
    result_free(&result);
}

Test(blame, a_task_with_a_fault_of_its_own_keeps_its_message_and_hint)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_FAILED, CHECK_FAILED};
    Result result = result_of(statuses, NULL);
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    cr_expect_str_eq(task_hint(&manifest, &result, &manifest.tasks[1]), "Play with cards.");
    result_free(&result);
}

// Both are wrong, and which of them made the picture look so, nobody knows.
Test(blame, of_two_wrong_answers_none_is_the_cause)
{
    const CheckStatus statuses[] = {CHECK_FAILED, CHECK_FAILED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[1].message, "found 1, expected 2; it looks mirrored");
    cr_expect_eq(result.checks[2].status, CHECK_FAILED);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2");
    result_free(&result);
}

// Who calls a function is at fault only where that function is not.
Test(blame, a_caller_is_not_at_fault_where_what_it_calls_is)
{
    static const Check calls[] = {
        {"overlap", "Touching counts", "search_leaf", 40, NULL, 0, 0},
        {"list", "The right ids", "trace", 20, "search_leaf", 0, 0},
        {"tree", "Whole trees", "trace", 40, "*", 0, 0},
    };
    const CheckStatus all[] = {CHECK_FAILED, CHECK_FAILED, CHECK_FAILED};
    Result result = result_of(all, NULL);
    blame_others(calls, &result);
    cr_expect_eq(result.checks[1].status, CHECK_NOT_RUN);
    cr_expect_eq(result.checks[2].status, CHECK_NOT_RUN);
    result_free(&result);
    const CheckStatus last[] = {CHECK_PASSED, CHECK_FAILED, CHECK_FAILED};
    result = result_of(last, NULL);
    blame_others(calls, &result);
    cr_expect_eq(result.checks[1].status, CHECK_FAILED);
    cr_expect_eq(result.checks[2].status, CHECK_FAILED);
    result_free(&result);
}

Test(blame, where_no_function_fails_the_whole_is_at_fault_itself)
{
    const CheckStatus statuses[] = {CHECK_NOT_RUN, CHECK_PASSED, CHECK_FAILED};
    Result result = result_of(statuses, "it looks mirrored");
    blame_others(checks, &result);
    cr_expect_str_eq(result.checks[2].message, "found 1, expected 2; it looks mirrored");
    result_free(&result);
}
