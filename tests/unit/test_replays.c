// judge/shared/replay.h and what judge_02_alone.c and judge_06_alone.c make of it: an answer tried
// alone passes with right answers, and with nothing missing, cut off or wrong.
#include "judge.h"
#include "manifest.h"
#include "right_answers_replays.h"

#include <criterion/parameterized.h>

TestSuite(replays);

static const char *const lab_names[] = {"02-kdtree-2d-build", "06-kdtree-3d-build"};

// ---- Jobs ---------------------------------------------------------------------------------------

// The job of a task alone, and right answers to it.
typedef struct Alone {
    const Judge *judge;
    const char *task;
    Job *job;
    Sections file;
    Sections answers;
} Alone;

static Alone alone_open(int lab, const char *task, uint64_t seed)
{
    Alone alone = {.judge = judge_of(lab_names[lab]), .task = task};
    Writer whole, own;
    writer_open(&whole);
    alone.job = job_new(alone.judge, seed, whole.file);
    Sections file = writer_close(&whole);
    sections_free(&file);
    cr_assert_not_null(alone.job);
    writer_open(&own);
    cr_assert_eq(job_write_alone(alone.job, task, own.file), 0);
    alone.file = writer_close(&own);
    alone.answers = right_answers_to(&alone.file, lab == 1);
    return alone;
}

static void alone_close(Alone *alone)
{
    job_free(alone->job);
    sections_free(&alone->file);
    sections_free(&alone->answers);
}

// How many checks of the task pass, those that only packing's own sections can answer apart.
static int n_passed(const Alone *alone, const Sections *answers)
{
    int n = 0;
    for (int i = 0; i < alone->judge->n_checks; i++) {
        n += strcmp(alone->judge->checks[i].task, alone->task) == 0 &&
             job_passes_alone(alone->job, i, answers);
    }
    return n;
}

// How many there are to pass.
static int n_checks(const Alone *alone)
{
    int n = 0;
    for (int i = 0; i < alone->judge->n_checks; i++) {
        const JudgeCheck *check = &alone->judge->checks[i];
        n += strcmp(check->task, alone->task) == 0 && strncmp(check->id, "pack-", 5) != 0;
    }
    return n;
}

// Each test runs for each task of both labs.
enum { MAX_TASKS = 16 };
typedef struct Case {
    int lab;
    char task[40];
} Case;

static struct criterion_test_params cases(void)
{
    static Case all[MAX_TASKS];
    size_t n = 0;
    for (int lab = 0; lab < 2; lab++) {
        Manifest manifest;
        cr_assert_eq(manifest_load("solutions", lab_names[lab], &manifest), 0);
        for (int t = 0; t < manifest.n_tasks; t++) {
            cr_assert_lt(n, MAX_TASKS);
            all[n].lab = lab;
            snprintf(all[n++].task, sizeof all->task, "%s", manifest.tasks[t].id);
        }
        manifest_free(&manifest);
    }
    return cr_make_param_array(Case, all, n);
}

#define TASK_TEST(name)                                                                            \
    ParameterizedTestParameters(replays, name)                                                     \
    {                                                                                              \
        return cases();                                                                            \
    }                                                                                              \
    ParameterizedTest(const Case *at, replays, name)

// ---- The tests ----------------------------------------------------------------------------------

TASK_TEST(right_answers_pass)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        Alone alone = alone_open(at->lab, at->task, seed);
        cr_expect_eq(n_passed(&alone, &alone.answers), n_checks(&alone), "%s", at->task);
        alone_close(&alone);
    }
}

TASK_TEST(without_answers_nothing_passes)
{
    Alone alone = alone_open(at->lab, at->task, 1);
    const Sections nothing = {0};
    for (int i = 0; i < alone.judge->n_checks; i++) {
        cr_expect_not(job_passes_alone(alone.job, i, &nothing), "%s", alone.judge->checks[i].id);
        cr_expect_not(job_passes_alone(alone.job, i, &alone.file),
                      "%s: the job is no answer to itself", alone.judge->checks[i].id);
    }
    alone_close(&alone);
}

// Small: the circles of lab 02's lists of more than 16 bits are the most that a job has, 7.4 MB.
TASK_TEST(a_job_alone_is_small_and_asks_for_no_tree)
{
    Alone alone = alone_open(at->lab, at->task, 1);
    size_t n_bytes;
    cr_expect_lt(alone.file.n_bytes, 8u << 20, "%s: %zu bytes", at->task, alone.file.n_bytes);
    cr_expect_null(sections_find_any(&alone.file, "scene.0", &n_bytes));
    alone_close(&alone);
}

// A word of a section: where it is in the file.
typedef struct Word {
    u32 *words;
    size_t n_words;
    const char *name;
} Word;

// The sections of replays, the next one from *offset on. Returns 0 when there is none.
static int next_section(Sections *sections, size_t *offset, Word *word)
{
    uint64_t n_bytes;
    if (*offset >= sections->n_bytes) {
        return 0;
    }
    word->name = (const char *)sections->bytes + *offset;
    memcpy(&n_bytes, sections->bytes + *offset + SECTION_NAME_BYTES, sizeof n_bytes);
    *offset += SECTION_NAME_BYTES + sizeof n_bytes;
    word->words = (u32 *)(sections->bytes + *offset);
    word->n_words = (size_t)n_bytes / sizeof(u32);
    *offset += ((size_t)n_bytes + SECTION_ALIGNMENT - 1) / SECTION_ALIGNMENT * SECTION_ALIGNMENT;
    return 1;
}

// All ends of the right answers but the last.
TASK_TEST(cut_off_answers_do_not_pass)
{
    Alone alone = alone_open(at->lab, at->task, 2);
    size_t offset = 0, end = 0;
    Word word;
    while (next_section(&alone.answers, &offset, &word)) {
        const Sections cut = {alone.answers.bytes, end};
        cr_expect_lt(n_passed(&alone, &cut), n_checks(&alone), "%s is missing", word.name);
        // A section that says it is a word longer than it is.
        uint64_t *n_bytes = (uint64_t *)(alone.answers.bytes + end + SECTION_NAME_BYTES);
        *n_bytes -= sizeof(u32);
        const int n = n_passed(&alone, &alone.answers);
        *n_bytes += sizeof(u32);
        cr_expect_lt(n, n_checks(&alone), "%s is short", word.name);
        end = offset;
    }
    alone_close(&alone);
}

// May anything stand in this word? Behind a list, where a node's ids have room.
static int is_free(const Word *word, size_t i)
{
    const int is_list = strcmp(word->name, "distribute") == 0 || strstr(word->name, "lists");
    return is_list && word->words[i] == UNTOUCHED;
}

// A word that is not right: the other decision, or another number.
static u32 other_word(u32 word)
{
    return word == 1 ? 0 : word ^ 0x40000000;
}

TASK_TEST(a_wrong_word_is_noticed)
{
    Alone alone = alone_open(at->lab, at->task, 3);
    size_t offset = 0;
    Word word;
    while (next_section(&alone.answers, &offset, &word)) {
        // Some of a long section.
        for (size_t i = 0; i < word.n_words; i += 1 + word.n_words / 61) {
            const u32 right = word.words[i];
            if (is_free(&word, i)) {
                continue;
            }
            word.words[i] = other_word(right);
            cr_expect_lt(n_passed(&alone, &alone.answers), n_checks(&alone), "%s, word %zu of %zu",
                         word.name, i, word.n_words);
            word.words[i] = right;
        }
    }
    alone_close(&alone);
}

// What is behind a list or a map.
TASK_TEST(guards_stay_untouched)
{
    Alone alone = alone_open(at->lab, at->task, 3);
    size_t offset = 0;
    Word word;
    while (next_section(&alone.answers, &offset, &word)) {
        const int is_map = strstr(word.name, ".map") != NULL;
        if (is_map || strcmp(word.name, "replay.lists") == 0) {
            for (size_t i = word.n_words - REPLAY_GUARD; i < word.n_words; i++) {
                cr_assert_eq(word.words[i], UNTOUCHED);
                word.words[i] = 7;
                cr_expect_lt(n_passed(&alone, &alone.answers), n_checks(&alone), "%s", word.name);
                word.words[i] = UNTOUCHED;
            }
        }
    }
    alone_close(&alone);
}
