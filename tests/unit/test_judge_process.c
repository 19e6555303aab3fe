// grader/judge_process: asking the judge, and answers over which it ends.
#include "judge_process.h"
#include "right_answers_sections.h"

#include <criterion/criterion.h>
#include <criterion/redirect.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

TestSuite(judge_process);

static JudgeProcess judge;
static Manifest manifest;

static int start_judge(void)
{
    const char *build = getenv("BUILD");
    return judge_start(&judge, build != NULL ? build : "build", &manifest, 7);
}

static void start(void)
{
    cr_assert_eq(manifest_load("solutions", "01-naive-2d", &manifest), 0);
    cr_assert_eq(start_judge(), 0);
}

static void stop(void)
{
    judge_stop(&judge);
    manifest_free(&manifest);
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

// A note stands where a student's code can write: nothing in it becomes a request of its own.
Test(judge_process, says_where_a_run_was, .init = start, .fini = stop)
{
    ProbeNote note = {.name = "overlaps", .input = PROBE_NO_INPUT};
    const RunPlace place = judge_place(&judge, &note);
    cr_expect_str_eq(place.where, "in overlaps_N_Nearer");
    cr_expect_str_eq(place.task, "overlaps_N_Nearer");
    cr_expect_eq(strncmp(place.with, "with one of ", 12), 0, "%s", place.with);
    static const char *const others[] = {"splits", "", "overlaps:1", "a 0\nadopt - 0"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        snprintf(note.name, sizeof note.name, "%s", others[i]);
        cr_expect_str_eq(judge_place(&judge, &note).where, "", "\"%s\"", others[i]);
    }
    cr_expect_eq(judge_verdict(&judge, (Answers){1, &empty}, 0).kind, VERDICT_MISSING);
}

// Started anew with the manifest as a test has changed it.
static void expect_refused(const char *message)
{
    char said[512] = "";
    judge_stop(&judge);
    cr_expect_neq(start_judge(), 0);
    fflush(stderr);
    said[fread(said, 1, sizeof said - 1, cr_get_redirected_stderr())] = '\0';
    cr_expect_str_eq(said, message);
}

static void start_silently(void)
{
    cr_redirect_stderr();
    start();
}

Test(judge_process, points_are_the_manifests, .init = start, .fini = stop)
{
    judge_stop(&judge);
    manifest.tasks[0].checks[0].points = 17;
    cr_assert_eq(start_judge(), 0);
    cr_expect_eq(judge.checks[0].points, 17);
}

Test(judge_process, a_check_without_points_is_refused, .init = start_silently, .fini = stop)
{
    manifest.tasks[1].n_checks--;
    expect_refused("solutions/01-naive-2d/lab.json: own_pixel: found no points for the check "
                   "\"own_pixel-padding\"\n");
    manifest.tasks[1].n_checks++;
}

Test(judge_process, points_for_no_check_of_the_task_are_refused, .init = start_silently,
     .fini = stop)
{
    const char **own = &manifest.tasks[0].checks[0].id, **others = &manifest.tasks[1].checks[0].id;
    const char *id = *own;
    *own = *others;
    *others = id;
    expect_refused("solutions/01-naive-2d/lab.json: overlaps_N_Nearer: found points for "
                   "\"own_pixel-picture\", which is no check of this task; its checks are in "
                   "tests/judge/01-naive-2d\n");
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

// As where answers have left it no memory.
Test(judge_process, a_job_comes_from_a_new_one_where_it_has_ended, .init = start, .fini = stop)
{
    size_t n_first, n_second;
    char *first = job_of(NULL, &n_first);
    cr_assert_eq(kill(judge.pid, SIGKILL), 0);
    char *second = job_of(NULL, &n_second);
    cr_expect_eq(n_first, n_second);
    cr_expect_eq(memcmp(first, second, n_first), 0);
    free(first), free(second);
}

Test(judge_process, what_is_missing_is_not_wrong, .init = start, .fini = stop)
{
    const Verdict verdict = judge_verdict(&judge, (Answers){1, &empty}, 0);
    cr_expect_eq(verdict.kind, VERDICT_MISSING);
    cr_expect_null(verdict.diagnosis.found);
    cr_expect_not(judge_passes_alone(&judge, (Answers){1, &empty}, 0));
}

// The judge's verdict on a check by its id.
static Verdict verdict_on(Answers answers, const char *id)
{
    int i = 0;
    while (i < judge.n_checks && strcmp(judge.checks[i].id, id) != 0) {
        i++;
    }
    cr_assert_lt(i, judge.n_checks);
    return judge_verdict(&judge, answers, i);
}

// The answer to the first picture, all pixels and the margin of this value, as answer `number`.
static Answers picture_of(unsigned number, float value, Sections *sections)
{
    enum { N_FLOATS = PROBE_IMAGE_SIDE(317) * PROBE_IMAGE_SIDE(100) * 4 };
    static float pixels[N_FLOATS];
    for (int i = 0; i < N_FLOATS; i++) {
        pixels[i] = value;
    }
    Writer writer;
    writer_open(&writer);
    answer(&writer, "picture.0", pixels, sizeof pixels);
    *sections = writer_close(&writer);
    return (Answers){number, sections};
}

Test(judge_process, a_diagnosis_arrives_in_its_parts, .init = start, .fini = stop)
{
    Sections sections;
    Answers black = picture_of(1, 0, &sections);
    Verdict picture = verdict_on(black, "own_pixel-picture");
    Verdict padding = verdict_on(black, "own_pixel-padding");
    cr_expect_eq(picture.kind, VERDICT_FAILED);
    cr_expect_eq(picture.diagnosis.evidence, EVIDENCE_PLAIN_PICTURE);
    cr_expect_null(picture.diagnosis.cause);
    cr_expect_eq(padding.diagnosis.evidence, EVIDENCE_VALUES);
    cr_expect_str_eq(padding.diagnosis.found, "the kernel wrote outside the picture: pixel (317, "
                                              "0) of a 317x100 picture");
    cr_expect_str_eq(
        padding.diagnosis.cause,
        "a guard for the work-items that fill up the last "
        "work-groups is missing or wrong, or a barrier comes behind it, which these never reach");
    diagnosis_free(&picture.diagnosis);
    diagnosis_free(&padding.diagnosis);
    sections_free(&sections);
    picture = verdict_on(picture_of(2, UNWRITTEN, &sections), "own_pixel-picture");
    cr_expect_eq(picture.diagnosis.mistake, MISTAKE_UNWRITTEN);
    diagnosis_free(&picture.diagnosis);
    sections_free(&sections);
}

// Whatever answers make of the judge: they fail, and the next ones are judged.
Test(judge_process, answers_over_which_it_ends_are_wrong, .init = start, .fini = stop)
{
    const Answers fatal = {1, &empty}, next = {2, &empty};
    kill(judge.pid, SIGKILL);
    for (int i = 0; i < 2; i++) {
        Verdict verdict = judge_verdict(&judge, fatal, i);
        cr_expect_eq(verdict.kind, VERDICT_FAILED);
        cr_expect_not_null(verdict.diagnosis.found);
        diagnosis_free(&verdict.diagnosis);
        cr_expect_not(judge_passes_alone(&judge, fatal, i));
    }
    cr_expect_eq(judge_verdict(&judge, next, 0).kind, VERDICT_MISSING);
}

Test(judge_process, a_lab_without_a_judge_is_refused)
{
    manifest = (Manifest){.lab = "44-none"};
    cr_expect_neq(start_judge(), 0);
    judge_stop(&judge);
}

// ---- Limits -------------------------------------------------------------------------------------

// The judge itself is limited, to 2 GB of memory. What the limits do is seen of another program.
Test(judge_process, its_memory_is_limited, .init = start, .fini = stop)
{
    char path[64], line[256];
    snprintf(path, sizeof path, "/proc/%d/limits", (int)judge.pid);
    FILE *limits = fopen(path, "r");
    cr_assert_not_null(limits);
    unsigned long long most = 0;
    while (fgets(line, sizeof line, limits) != NULL) {
        sscanf(line, "Max address space %llu", &most);
    }
    fclose(limits);
    cr_expect_eq(most, 2ull << 30, "found %llu", most);
}

// A build folder in which the judge is greedy_judge.
static char greedy_build[] = "/tmp/greedy-judge-XXXXXX";

static void greedy_start(void)
{
    char judges[64], link[96], program[PATH_MAX], greedy[PATH_MAX + 32];
    const char *build = getenv("BUILD");
    cr_assert_not_null(realpath(build != NULL ? build : "build", program));
    cr_assert_not_null(mkdtemp(greedy_build));
    snprintf(judges, sizeof judges, "%s/judges", greedy_build);
    snprintf(link, sizeof link, "%s/01-naive-2d", judges);
    snprintf(greedy, sizeof greedy, "%s/tools/greedy_judge", program);
    cr_assert_eq(mkdir(judges, 0755), 0);
    cr_assert_eq(symlink(greedy, link), 0);
    manifest = (Manifest){.lab = "01-naive-2d"};  // of no checks, as it has none
    cr_assert_eq(judge_start(&judge, greedy_build, &manifest, 7), 0);
}

static void greedy_stop(void)
{
    char judges[64], link[96];
    judge_stop(&judge);
    snprintf(judges, sizeof judges, "%s/judges", greedy_build);
    snprintf(link, sizeof link, "%s/01-naive-2d", judges);
    unlink(link);
    rmdir(judges);
    rmdir(greedy_build);
}

// What a check comes to over answers that it has not seen yet.
static VerdictKind greedy_verdict(int check)
{
    static unsigned number;
    Verdict verdict = judge_verdict(&judge, (Answers){++number, &empty}, check);
    cr_expect_eq(verdict.diagnosis.found != NULL, verdict.kind == VERDICT_FAILED);
    diagnosis_free(&verdict.diagnosis);
    return verdict.kind;
}

Test(judge_process, answers_that_take_all_its_time_are_wrong, .init = greedy_start,
     .fini = greedy_stop)
{
    cr_expect_eq(greedy_verdict(0), VERDICT_FAILED);
    cr_expect_eq(greedy_verdict(2), VERDICT_PASSED, "the next ones are judged");
}

Test(judge_process, answers_that_take_all_its_memory_are_wrong, .init = greedy_start,
     .fini = greedy_stop)
{
    cr_expect_eq(greedy_verdict(1), VERDICT_FAILED);
    cr_expect_eq(greedy_verdict(2), VERDICT_PASSED, "the next ones are judged");
}

// Each request has the time anew: none adds up with those before.
Test(judge_process, time_is_counted_from_each_request_on, .init = greedy_start, .fini = greedy_stop)
{
    for (int i = 0; i < 4; i++) {
        cr_expect_eq(greedy_verdict(2), VERDICT_PASSED, "request %d", i);
    }
}
