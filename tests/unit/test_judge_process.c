// grader/judge_process: asking the judge, and answers over which it ends.
#include "judge_process.h"

#include <criterion/criterion.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

TestSuite(judge_process);

static JudgeProcess judge;

static void start(void)
{
    const char *build = getenv("BUILD");
    cr_assert_eq(judge_start(&judge, build != NULL ? build : "build", "01-naive-2d", 7), 0);
}

static void stop(void)
{
    judge_stop(&judge);
}

// Answers without a section.
static const Sections empty;

Test(judge_process, the_checks_are_the_labs, .init = start, .fini = stop)
{
    int points = 0;
    for (int i = 0; i < judge.n_checks; i++) {
        points += judge.checks[i].points;
    }
    cr_expect_eq(points, 100);
    cr_expect_str_eq(judge.checks[0].id, "overlaps-inside");
    cr_expect_str_eq(judge.checks[0].task, "overlaps_N_Nearer");
}

// The job's bytes. Owned by the caller.
static char *job_of(const char *task, size_t *n_bytes)
{
    char *bytes = NULL;
    FILE *file = open_memstream(&bytes, n_bytes);
    cr_assert_eq(judge_job(&judge, task, file), 0);
    fclose(file);
    return bytes;
}

Test(judge_process, a_job_is_the_same_each_time_and_a_tasks_is_smaller, .init = start, .fini = stop)
{
    size_t n_first, n_second, n_alone;
    char *first = job_of(NULL, &n_first), *second = job_of(NULL, &n_second);
    char *alone = job_of("overlaps_N_Nearer", &n_alone);
    cr_expect_gt(n_alone, 0);
    cr_expect_lt(n_alone, n_first);
    cr_expect_eq(n_first, n_second);
    cr_expect_eq(memcmp(first, second, n_first), 0);
    free(first), free(second), free(alone);
}

Test(judge_process, what_is_missing_is_not_wrong, .init = start, .fini = stop)
{
    const Verdict verdict = judge_verdict(&judge, (Answers){1, &empty}, 0);
    cr_expect_eq(verdict.kind, VERDICT_MISSING);
    cr_expect_null(verdict.message);
    cr_expect_not(judge_passes_alone(&judge, (Answers){1, &empty}, 0));
}

// Whatever answers make of the judge: they fail, and the next ones are judged.
Test(judge_process, answers_over_which_it_ends_are_wrong, .init = start, .fini = stop)
{
    const Answers fatal = {1, &empty}, next = {2, &empty};
    kill(judge.pid, SIGKILL);
    for (int i = 0; i < 2; i++) {
        const Verdict verdict = judge_verdict(&judge, fatal, i);
        cr_expect_eq(verdict.kind, VERDICT_FAILED);
        cr_expect_not_null(verdict.message);
        free(verdict.message);
        cr_expect_not(judge_passes_alone(&judge, fatal, i));
    }
    cr_expect_eq(judge_verdict(&judge, next, 0).kind, VERDICT_MISSING);
}

Test(judge_process, a_lab_without_a_judge_is_refused)
{
    cr_expect_neq(judge_start(&judge, getenv("BUILD") ? getenv("BUILD") : "build", "44-none", 7),
                  0);
    judge_stop(&judge);
}
