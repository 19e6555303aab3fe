// judge/judge_NN: each lab's checks and job; right answers pass, missing ones do not.
//
// The right answers are the solution's; that they pass shows that what other tests do to them
// afterwards is what fails. Read next: right_answers.h.
#include "judged_jobs.h"
#include "nonce.h"
#include "one_way.h"

#include <glob.h>

TestSuite(judges);

// ---- The tables ---------------------------------------------------------------------------------

Test(judges, every_lab_has_one)
{
    glob_t folders;
    cr_assert_eq(glob("solutions/*", GLOB_ONLYDIR, NULL, &folders), 0, "start in the top folder");
    cr_expect_eq(folders.gl_pathc, N_LABS, "a new lab belongs into this suite");
    for (size_t i = 0; i < folders.gl_pathc; i++) {
        const char *lab = strchr(folders.gl_pathv[i], '/') + 1;
        const Judge *judge = judge_of(lab);
        cr_expect(judge != NULL && strcmp(judge->lab, lab) == 0, "%s", lab);
    }
    globfree(&folders);
    cr_expect_null(judge_of("00-hello"));
    cr_expect_null(judge_of(""));
}

// Which points a check earns, and whether each has some: judge_start().
LAB_TEST(judges, each_check_has_its_name)
{
    const Judge *judge = judge_of(lab_names[*lab]);
    cr_assert_leq(judge->n_checks, RESULT_MAX_CHECKS);
    for (int i = 0; i < judge->n_checks; i++) {
        const JudgeCheck *check = &judge->checks[i];
        cr_assert(check->id != NULL && check->title != NULL && check->task != NULL, "check %d", i);
        for (int j = 0; j < i; j++) {
            cr_expect_str_neq(check->id, judge->checks[j].id);
        }
    }
}

// A row names one who decides, and inputs or scenes that are there.
LAB_TEST(judges, each_check_is_decided_by_one)
{
    const Judge *judge = judge_of(lab_names[*lab]);
    for (int i = 0; i < judge->n_checks; i++) {
        const JudgeCheck *check = &judge->checks[i];
        cr_expect_eq((check->function != NULL) + (check->scene != NULL) + (check->tree != NULL) +
                         (check->all != NULL),
                     1, "%s", check->id);
        cr_expect_eq(check->tree != NULL, check->tree2d != NULL || check->tree3d != NULL, "%s",
                     check->id);
        cr_expect_leq((check->alone != NULL) + (check->alone_scene != NULL) +
                          (check->replay != NULL),
                      1, "%s", check->id);
        cr_expect_eq(check->range.n > 0, check->all == NULL, "%s", check->id);
        if (check->function != NULL) {
            cr_expect_lt(range_at(check->range, check->range.n - 1), check->function->n, "%s",
                         check->id);
        }
    }
}

LAB_TEST(judges, a_seed_says_all_about_a_job)
{
    Open first = job_open(*lab, 7), same = job_open(*lab, 7), other = job_open(*lab, 8);
    cr_expect_eq(first.file.n_bytes, same.file.n_bytes);
    cr_expect_eq(memcmp(first.file.bytes, same.file.bytes, first.file.n_bytes), 0);
    cr_expect(other.file.n_bytes != first.file.n_bytes ||
              memcmp(first.file.bytes, other.file.bytes, first.file.n_bytes) != 0);
    job_close(&first);
    job_close(&same);
    job_close(&other);
}

// The attack: a run knows how jobs are rolled, and tries states of the generator until one gives
// the inputs that it sees. (Here few need trying; of a number that is rolled whole, the state can
// be computed.) If that state were the seed, it would say what the stubs hold.
static int rolls_the_same(const Judge *judge, uint64_t state, const Job *seen)
{
    Random random = {state};
    Job *job = calloc(1, judge->job_bytes);
    cr_assert_not_null(job);
    job->judge = judge;
    cr_assert_eq(judge->roll(job, &random), 0);
    int is_same = 1;
    for (int i = 0; i < judge->n_parts; i++) {
        const JobPart *part = &judge->parts[i];
        is_same &= memcmp((const char *)job + part->offset, (const char *)seen + part->offset,
                          part->n_bytes) == 0;
    }
    job_free(job);
    return is_same;
}

LAB_TEST(judges, inputs_do_not_tell_the_nonce)
{
    const uint64_t seed = 7;
    Open open = job_open(*lab, seed);
    for (uint64_t state = seed - 2; open.judge->n_parts > 0 && state <= seed + 2; state++) {
        cr_expect_not(
            rolls_the_same(open.judge, state, open.job) && stub_nonce(state) == open.job->nonce,
            "%s: the state %d gives its inputs, and its nonce", open.judge->lab, (int)state);
    }
    const uint64_t state = one_way(seed, PURPOSE_INPUTS);
    cr_expect(open.judge->n_parts == 0 || rolls_the_same(open.judge, state, open.job),
              "the test would not see it");
    cr_expect_neq(stub_nonce(state), open.job->nonce);
    job_close(&open);
}

LAB_TEST(judges, a_job_that_cannot_be_written_is_none)
{
    FILE *full = fopen("/dev/full", "wb");
    cr_assert_not_null(full);
    cr_expect_null(job_new(judge_of(lab_names[*lab]), 7, full));
    fclose(full);
}

// ---- Verdicts -----------------------------------------------------------------------------------

LAB_TEST(judges, right_answers_pass)
{
    for (uint64_t seed = 1; seed <= (uint64_t)quick(1, 3); seed++) {
        Open open = job_open(*lab, seed);
        Sections answers = right_answers(lab_names[*lab], open.seed);
        for (int adopted = 0; adopted <= 1; adopted++) {
            for (int i = 0; i < open.judge->n_checks; i++) {
                const Verdict verdict = job_judge(open.job, i, &answers);
                char *message = told(verdict.diagnosis);
                cr_expect_eq(verdict.kind, VERDICT_PASSED, "%s: %s", open.judge->checks[i].id,
                             message ? message : "missing");
                free(message);
            }
            add_pictures(&open, &answers);
            job_adopt(open.job, &answers);
        }
        sections_free(&answers);
        job_close(&open);
    }
}

// Each check, and the same as a task tried alone has it; see grader/alone.h.
static void expect_nothing_passes(const Open *open)
{
    Sections nothing = {0}, job = open->file;
    for (int i = 0; i < open->judge->n_checks; i++) {
        cr_expect_eq(verdict_on(open, i, &nothing), VERDICT_MISSING);
        cr_expect_eq(verdict_on(open, i, &job), VERDICT_MISSING, "the job is no answer to itself");
        cr_expect_eq(job_passes_alone(open->job, i, &nothing), 0);
        cr_expect_eq(job_passes_alone(open->job, i, &job), 0, "the job is no answer");
    }
    add_pictures(open, &nothing);
}

// What a task is tried on alone, as the probe reads it.
static Sections alone_job(const Open *open, const char *task)
{
    Writer writer;
    writer_open(&writer);
    cr_expect_eq(job_write_alone(open->job, task, writer.file), 0, "%s", task);
    return writer_close(&writer);
}

static void expect_jobs_alone(const Open *open)
{
    FILE *full = fopen("/dev/full", "wb");
    for (int i = 0; i < open->judge->n_checks; i++) {
        const char *task = open->judge->checks[i].task;
        Sections job = alone_job(open, task);
        cr_expect(job.n_bytes > 0, "%s", task);
        cr_expect_neq(job_write_alone(open->job, task, full), 0, "%s", task);
        sections_free(&job);
    }
    fclose(full);
}

// Of one job, as rolling it takes longer than this.
LAB_TEST(judges, without_answers_nothing_passes_and_every_task_has_a_job_alone)
{
    Open open = job_open(*lab, 1);
    expect_nothing_passes(&open);
    expect_jobs_alone(&open);
    job_close(&open);
}
