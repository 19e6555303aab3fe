// A lab's job and its judge, opened; the sections of its answers, and verdicts on them.
//
// For the tests that run once a lab. Read next: test_judges.c.
#ifndef UNIT_JUDGED_JOBS_H
#define UNIT_JUDGED_JOBS_H

#include "judge.h"
#include "right_answers.h"
#include "surroundings.h"
#include "told.h"

#include <criterion/parameterized.h>

static const char *const lab_names[] = {
    "00-hello-pixels",        "01-naive-2d",        "02-kdtree-2d-build",
    "03-kdtree-2d-render",    "04-camera-rays",     "05-spheres",
    "06-kdtree-3d-build",     "07-kdtree-3d-trace", "08-surface-area-heuristic",
    "09-shadows-and-mirrors", "10-realtime"};
enum { N_LABS = sizeof lab_names / sizeof *lab_names };

// Each test runs once a lab.
#define LAB_TEST(suite, name)                                                                      \
    ParameterizedTestParameters(suite, name)                                                       \
    {                                                                                              \
        static int numbers[N_LABS];                                                                \
        for (int i = 0; i < N_LABS; i++) {                                                         \
            numbers[i] = i;                                                                        \
        }                                                                                          \
        return cr_make_param_array(int, numbers, N_LABS);                                          \
    }                                                                                              \
    ParameterizedTest(const int *lab, suite, name)

// How many of what is tried again and again: `make test` tries the quick part (tests/tap.sh), `make
// test-all` all.
static inline int quick(int few, int all)
{
    const char *is_quick = getenv("QUICK");
    return is_quick != NULL && is_quick[0] != '\0' ? few : all;
}

// ---- Section files in memory --------------------------------------------------------------------

// One section of a file, as sections.h lays it out.
typedef struct Section {
    char name[SECTION_NAME_BYTES];
    const unsigned char *bytes;
    size_t n_bytes;
} Section;

enum { MAX_SECTIONS = 128 };

static inline int list_sections(const Sections *sections, Section list[MAX_SECTIONS])
{
    int n = 0;
    for (size_t at = 0; at < sections->n_bytes; n++) {
        cr_assert_lt(n, MAX_SECTIONS);
        uint64_t n_bytes;
        memcpy(list[n].name, sections->bytes + at, SECTION_NAME_BYTES);
        memcpy(&n_bytes, sections->bytes + at + SECTION_NAME_BYTES, sizeof n_bytes);
        list[n].bytes = sections->bytes + at + SECTION_NAME_BYTES + sizeof n_bytes;
        list[n].n_bytes = (size_t)n_bytes;
        at += SECTION_NAME_BYTES + sizeof n_bytes +
              (list[n].n_bytes + SECTION_ALIGNMENT - 1) / SECTION_ALIGNMENT * SECTION_ALIGNMENT;
    }
    return n;
}

// ---- Jobs ---------------------------------------------------------------------------------------

// A job, as the judge keeps it and as the probe reads it.
typedef struct Open {
    const Judge *judge;
    uint64_t seed;
    Job *job;
    Sections file;
} Open;

static inline Open job_open(int lab, uint64_t seed)
{
    Open open = {.judge = judge_of(lab_names[lab]), .seed = seed};
    cr_assert_not_null(open.judge, "%s", lab_names[lab]);
    Writer writer;
    writer_open(&writer);
    open.job = job_new(open.judge, seed, writer.file);
    open.file = writer_close(&writer);
    cr_assert_not_null(open.job);
    return open;
}

static inline void job_close(Open *open)
{
    job_free(open->job);
    sections_free(&open->file);
}

// ---- Verdicts -----------------------------------------------------------------------------------

// A check's verdict without its message; a message comes with a failure and only then.
static inline VerdictKind verdict_on(const Open *open, int check, const Sections *answers)
{
    const Verdict verdict = job_judge(open->job, check, answers);
    char *message = told(verdict.diagnosis);
    cr_expect_eq(message != NULL, verdict.kind == VERDICT_FAILED, "%s",
                 open->judge->checks[check].id);
    cr_expect(message == NULL || strlen(message) > 10);
    free(message);
    return verdict.kind;
}

// The report's pictures are made from the same answers.
static inline void add_pictures(const Open *open, const Sections *answers)
{
    Result *result = calloc(1, sizeof *result);
    job_add_pictures(open->job, answers, result);
    cr_expect(result->n_pictures > 0 && result->n_pictures <= RESULT_MAX_PICTURES);
    result_free(result);
    free(result);
}

#endif
