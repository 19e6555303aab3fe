// judge/judge_NN: each lab's checks and job, right answers, and answers that are missing, of a
// wrong size or garbage.
//
// The right answers are worked out in plain C; that they pass shows that what is done to them
// afterwards is what fails. Read next: right_answers.h.
#include "judge.h"
#include "manifest.h"
#include "random.h"
#include "right_answers.h"
#include "surroundings.h"

#include <criterion/parameterized.h>
#include <glob.h>
#include <math.h>

TestSuite(judges);

static const char *const lab_names[] = {
    "00-hello-pixels", "01-naive-2d", "02-kdtree-2d-build", "03-kdtree-2d-render",
    "04-camera-rays",  "05-spheres",  "06-kdtree-3d-build", "07-kdtree-3d-trace"};
enum { N_LABS = sizeof lab_names / sizeof *lab_names };

// Each test runs once a lab.
#define LAB_TEST(name)                                                                             \
    ParameterizedTestParameters(judges, name)                                                      \
    {                                                                                              \
        static int numbers[N_LABS];                                                                \
        for (int i = 0; i < N_LABS; i++) {                                                         \
            numbers[i] = i;                                                                        \
        }                                                                                          \
        return cr_make_param_array(int, numbers, N_LABS);                                          \
    }                                                                                              \
    ParameterizedTest(const int *lab, judges, name)

// ---- Section files in memory --------------------------------------------------------------------

// One section of a file, as sections.h lays it out.
typedef struct Section {
    char name[SECTION_NAME_BYTES];
    const unsigned char *bytes;
    size_t n_bytes;
} Section;

enum { MAX_SECTIONS = 128 };

// With more sections than this a test does one thing to each, another to the next: lab 07 has so
// many of a kind, and judging is slow with sanitizers.
enum { MANY_SECTIONS = 64 };

static int list_sections(const Sections *sections, Section list[MAX_SECTIONS])
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
    Job *job;
    Sections file;
} Open;

static Open job_open(int lab, uint64_t seed)
{
    Open open = {.judge = judge_of(lab_names[lab])};
    cr_assert_not_null(open.judge, "%s", lab_names[lab]);
    Writer writer;
    writer_open(&writer);
    open.job = job_new(open.judge, seed, writer.file);
    open.file = writer_close(&writer);
    cr_assert_not_null(open.job);
    return open;
}

static void job_close(Open *open)
{
    job_free(open->job);
    sections_free(&open->file);
}

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

LAB_TEST(checks_add_up)
{
    Manifest manifest;
    cr_assert_eq(manifest_load("solutions", lab_names[*lab], &manifest), 0);
    const Judge *judge = judge_of(lab_names[*lab]);
    int sum = 0, task_sums[MANIFEST_MAX_TASKS] = {0};
    cr_assert_leq(judge->n_checks, RESULT_MAX_CHECKS);
    for (int i = 0; i < judge->n_checks; i++) {
        const JudgeCheck *check = &judge->checks[i];
        cr_assert(check->id != NULL && check->title != NULL, "check %d", i);
        const Task *task = manifest_task(&manifest, check->task);
        cr_assert_not_null(task, "%s: no task called %s", check->id, check->task);
        cr_expect_gt(check->points, 0, "%s", check->id);
        sum += check->points;
        task_sums[task - manifest.tasks] += check->points;
        for (int j = 0; j < i; j++) {
            cr_expect_str_neq(check->id, judge->checks[j].id);
        }
    }
    cr_expect_eq(sum, 100);
    for (int i = 0; i < manifest.n_tasks; i++) {
        cr_expect_eq(task_sums[i], manifest.tasks[i].points, "%s", manifest.tasks[i].id);
    }
    manifest_free(&manifest);
}

// A row names one who decides, and inputs or scenes that are there.
LAB_TEST(each_check_is_decided_by_one)
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

LAB_TEST(a_seed_says_all_about_a_job)
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

LAB_TEST(a_job_that_cannot_be_written_is_none)
{
    FILE *full = fopen("/dev/full", "wb");
    cr_assert_not_null(full);
    cr_expect_null(job_new(judge_of(lab_names[*lab]), 7, full));
    fclose(full);
}

// ---- Verdicts -----------------------------------------------------------------------------------

// A check's verdict without its message; a message comes with a failure and only then.
static VerdictKind verdict_on(const Open *open, int check, const Sections *answers)
{
    const Verdict verdict = job_judge(open->job, check, answers);
    cr_expect_eq(verdict.message != NULL, verdict.kind == VERDICT_FAILED, "%s",
                 open->judge->checks[check].id);
    cr_expect(verdict.message == NULL || strlen(verdict.message) > 10);
    free(verdict.message);
    return verdict.kind;
}

// The report's pictures are made from the same answers.
static void add_pictures(const Open *open, const Sections *answers)
{
    Result *result = calloc(1, sizeof *result);
    job_add_pictures(open->job, answers, result);
    cr_expect(result->n_pictures > 0 && result->n_pictures <= RESULT_MAX_PICTURES);
    result_free(result);
    free(result);
}

LAB_TEST(right_answers_pass)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        Open open = job_open(*lab, seed);
        Sections answers = right_answers(*lab, &open.file);
        for (int adopted = 0; adopted <= 1; adopted++) {
            for (int i = 0; i < open.judge->n_checks; i++) {
                const Verdict verdict = job_judge(open.job, i, &answers);
                cr_expect_eq(verdict.kind, VERDICT_PASSED, "%s: %s", open.judge->checks[i].id,
                             verdict.message ? verdict.message : "missing");
                free(verdict.message);
            }
            add_pictures(&open, &answers);
            job_adopt(open.job, &answers);
        }
        sections_free(&answers);
        job_close(&open);
    }
}

LAB_TEST(without_answers_nothing_is_judged)
{
    Open open = job_open(*lab, 1);
    Sections nothing = {0}, job = open.file;
    for (int i = 0; i < open.judge->n_checks; i++) {
        cr_expect_eq(verdict_on(&open, i, &nothing), VERDICT_MISSING);
        cr_expect_eq(verdict_on(&open, i, &job), VERDICT_MISSING, "the job is no answer to itself");
    }
    add_pictures(&open, &nothing);
    job_close(&open);
}

// Each check as a task tried alone has it; see grader/alone.h.
LAB_TEST(without_answers_nothing_passes_alone)
{
    Open open = job_open(*lab, 1);
    Sections nothing = {0}, job = open.file;
    for (int i = 0; i < open.judge->n_checks; i++) {
        cr_expect_eq(job_passes_alone(open.job, i, &nothing), 0);
        cr_expect_eq(job_passes_alone(open.job, i, &job), 0, "the job is no answer");
    }
    job_close(&open);
}

// What a task is tried on alone, as the probe reads it.
static Sections alone_job(const Open *open, const char *task)
{
    Writer writer;
    writer_open(&writer);
    cr_expect_eq(job_write_alone(open->job, task, writer.file), 0, "%s", task);
    return writer_close(&writer);
}

LAB_TEST(every_task_has_a_job_alone)
{
    Open open = job_open(*lab, 1);
    FILE *full = fopen("/dev/full", "wb");
    for (int i = 0; i < open.judge->n_checks; i++) {
        const char *task = open.judge->checks[i].task;
        Sections job = alone_job(&open, task);
        cr_expect(job.n_bytes > 0, "%s", task);
        cr_expect_neq(job_write_alone(open.job, task, full), 0, "%s", task);
        sections_free(&job);
    }
    fclose(full);
    job_close(&open);
}

// ---- Answers that are not whole -----------------------------------------------------------------

typedef enum Damage { DROPPED, EMPTY, TRUNCATED, OVERSIZED, TWICE, N_DAMAGES } Damage;

// The answers with one section damaged.
static Sections damaged(const Section list[], int n, int victim, Damage damage)
{
    Writer writer;
    writer_open(&writer);
    for (int i = 0; i < n; i++) {
        const Section *s = &list[i];
        if (i != victim || damage == TWICE) {
            answer(&writer, s->name, s->bytes, s->n_bytes);
        }
        if (i == victim && damage != DROPPED) {
            unsigned char *bytes = calloc(s->n_bytes + 1, 1);
            memcpy(bytes, s->bytes, s->n_bytes);
            answer(&writer, s->name, bytes,
                   damage == EMPTY       ? 0
                   : damage == TRUNCATED ? s->n_bytes - 1
                                         : s->n_bytes + (damage == OVERSIZED));
            free(bytes);
        }
    }
    return writer_close(&writer);
}

LAB_TEST(a_section_of_a_wrong_size_is_missing)
{
    Open open = job_open(*lab, 2);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    for (int victim = 0; victim < n; victim++) {
        const int is_one_of_many = n > MANY_SECTIONS;
        for (int damage = is_one_of_many ? victim % N_DAMAGES : DROPPED; damage < N_DAMAGES;
             damage += is_one_of_many ? N_DAMAGES : 1) {
            // Where nothing is right: a list of no ids, or that a tree was refused.
            if (list[victim].n_bytes == 0 && (damage == EMPTY || damage == TRUNCATED)) {
                continue;
            }
            Sections bad = damaged(list, n, victim, damage);
            int n_hit = 0;
            for (int i = 0; i < open.judge->n_checks; i++) {
                const VerdictKind kind = verdict_on(&open, i, &bad);
                // A picture of another size is wrong as well as not to be found.
                const int is_resized = strncmp(list[victim].name, "picture.", 8) == 0 &&
                                       damage != DROPPED && damage != TWICE &&
                                       kind == VERDICT_FAILED;
                cr_expect(kind == VERDICT_PASSED || kind == VERDICT_MISSING || is_resized,
                          "%s, damage %d: %s", list[victim].name, damage, open.judge->checks[i].id);
                n_hit += kind == VERDICT_MISSING || is_resized;
            }
            cr_expect_gt(n_hit, 0, "%s, damage %d: nobody noticed", list[victim].name, damage);
            if (damage == DROPPED || damage == OVERSIZED) {
                add_pictures(&open, &bad);
            }
            sections_free(&bad);
        }
    }
    sections_free(&answers);
    job_close(&open);
}

// ---- Garbage ------------------------------------------------------------------------------------

enum { RANDOM_BYTES, RANDOM_FLOATS, RANDOM_SMALL, ZEROS, ONES, NANS, INFINITIES, NOBODY, N_KINDS };

static void fill_with_garbage(int kind, Random *random, unsigned char *bytes, size_t n_bytes)
{
    static const float floats[] = {[NANS] = NAN, [INFINITIES] = INFINITY, [NOBODY] = UNWRITTEN};
    for (size_t i = 0; i < n_bytes; i += 4) {
        uint32_t word = (uint32_t)random_bits(random);
        const float number = kind == RANDOM_FLOATS ? (float)(word % 1000) / 1000 : floats[kind];
        if (kind == RANDOM_SMALL) {
            word %= 40;
        } else if (kind == ZEROS || kind == ONES) {
            word = kind == ONES ? 0xffffffff : 0;
        } else if (kind != RANDOM_BYTES) {
            memcpy(&word, &number, sizeof word);
        }
        memcpy(bytes + i, &word, n_bytes - i < 4 ? n_bytes - i : 4);
    }
}

// A tree's header ends with the sizes of its arrays.
_Static_assert(offsetof(TreeAnswer, n_nodes) == sizeof(TreeAnswer) - 2 * sizeof(u32) &&
                   offsetof(TreeAnswer3D, n_nodes) == sizeof(TreeAnswer3D) - 2 * sizeof(u32),
               "they are the last two words");

// How many bytes at the end of a section stay right when all sections get garbage: the sizes of a
// tree's arrays, so that those are looked at.
static size_t n_kept(const Section *section)
{
    const int is_tree_header =
        strncmp(section->name, "tree.", 5) == 0 && strchr(section->name + 5, '.') == NULL;
    return is_tree_header ? 2 * sizeof(u32) : 0;
}

// The answers with garbage in one section, in all of them when victim is -1.
static Sections garbled(const Section list[], int n, int victim, int kind, Random *random)
{
    Writer writer;
    writer_open(&writer);
    for (int i = 0; i < n; i++) {
        unsigned char *bytes = malloc(list[i].n_bytes + 1);
        memcpy(bytes, list[i].bytes, list[i].n_bytes);
        if (victim == i || victim < 0) {
            fill_with_garbage(kind, random, bytes,
                              list[i].n_bytes - (victim < 0 ? n_kept(&list[i]) : 0));
        }
        answer(&writer, list[i].name, bytes, list[i].n_bytes);
        free(bytes);
    }
    return writer_close(&writer);
}

LAB_TEST(garbage_passes_no_check)
{
    Open open = job_open(*lab, 3);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {4};
    for (int kind = 0; kind < N_KINDS; kind++) {
        Sections bad = garbled(list, n, -1, kind, &random);
        for (int i = 0; i < open.judge->n_checks; i++) {
            const JudgeCheck *check = &open.judge->checks[i];
            cr_expect_eq(verdict_on(&open, i, &bad), VERDICT_FAILED, "garbage %d: %s", kind,
                         check->id);
        }
        if (kind == RANDOM_BYTES || kind == NANS) {
            add_pictures(&open, &bad);
        }
        sections_free(&bad);
    }
    sections_free(&answers);
    job_close(&open);
}

_Static_assert(TIE == 31, "the picture below");

static int passes_everything(const Open *open, const Sections *answers)
{
    int i = 0;
    while (i < open->judge->n_checks && verdict_on(open, i, answers) == VERDICT_PASSED) {
        i++;
    }
    return i == open->judge->n_checks;
}

LAB_TEST(garbage_in_one_section_is_noticed)
{
    Open open = job_open(*lab, 5);
    Sections answers = right_answers(*lab, &open.file);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {6};
    for (int victim = 0; victim < n; victim++) {
        // Three kinds a section, others for the next.
        const int step = n > MANY_SECTIONS ? N_KINDS : 3;
        for (int kind = victim % step; kind < N_KINDS; kind += step) {
            // Zeros are the right picture of a scene without circles. Of the tree that just fits
            // the todo stack only its depth is judged, of lab 07's tie what is hit.
            if (kind == ZEROS || (*lab == 6 && strcmp(list[victim].name, "tree.10.ids") == 0) ||
                (*lab == 7 && strcmp(list[victim].name, "picture.31") == 0)) {
                continue;
            }
            Sections bad = garbled(list, n, victim, kind, &random);
            // Garbage may be what is right: the map of no circle is a zero.
            const int is_same = bad.n_bytes == answers.n_bytes &&
                                memcmp(bad.bytes, answers.bytes, bad.n_bytes) == 0;
            cr_expect(is_same || !passes_everything(&open, &bad), "garbage %d in %s", kind,
                      list[victim].name);
            sections_free(&bad);
        }
    }
    sections_free(&answers);
    job_close(&open);
}

// Sections of which every word counts, but for those of is_free(); a wrong word is the other
// decision, or another bit.
static const struct {
    int lab;
    const char *name;
    int is_decision;
} whole_sections[] = {
    {0, "readback.1", 0},   {0, "arguments.2", 0},
    {1, "overlaps", 1},     {2, "leaves", 1},
    {2, "splits", 0},       {2, "overlaps", 1},
    {2, "distribute", 0},   {2, "pack", 0},
    {2, "tree.1.map", 0},   {2, "tree.1.relations", 0},
    {2, "tree.1.boxes", 0}, {3, "children", 0},
    {4, "axes", 0},         {5, "roots", 0},
    {5, "normals", 0},      {6, "splits", 0},
    {6, "overlaps", 1},     {6, "pack", 0},
    {6, "todo", 1},         {6, "tree.0", 0},
    {6, "tree.0.nodes", 0}, {6, "tree.0.ids", 0},
    {6, "tree.2.nodes", 0}, {6, "tree.2.ids", 0},
    {7, "clips", 0},        {7, "sides", 0},
    {7, "planes", 0},       {7, "leaves", 0},
    {7, "next_child", 0},   {7, "next_waiting", 0},
    {7, "hits.0", 0},       {7, "work.2", 0},
};

// May anything stand in a word of lab 06's or 07's answers?
static int is_free(int lab, const char *name, const u32 *words, size_t at)
{
    if (lab == 6 && (strcmp(name, "pack") == 0 || strstr(name, ".nodes") != NULL)) {
        return at % 4 == 0 && words[at + 1] == KD_LEAF;  // a leaf's split_pos
    }
    if (lab == 7 && strcmp(name, "clips") == 0) {
        return at % 3 != 0 && !words[at - at % 3];  // the part of a ray that misses the box
    }
    if (lab == 7 && strcmp(name, "planes") == 0) {
        return at % 2 == 1 && words[at - 1] != PLANE_BOTH;  // t_split
    }
    if (lab == 7 && strcmp(name, "leaves") == 0) {
        // The first half is about distances, the second about whose they are.
        return at % 3 == (at / 3 < N_LEAF_INPUTS);
    }
    if (lab == 7 && strncmp(name, "next_", 5) == 0) {
        // A NextChildAnswer or a NextWaitingAnswer; above the top of a stack anything may stand.
        const size_t n_before = strcmp(name, "next_child") == 0 ? 3 : 4;
        const size_t size = n_before + sizeof(StackState) / sizeof *words;
        const u32 *answer = words + at - at % size;
        const size_t n_used = n_before + 2 + 3 * (size_t)(answer[n_before + 1] - answer[n_before]);
        return at % size >= n_used || (n_before == 4 && at % size > 0 && answer[0] == 0);
    }
    return 0;
}

// A word that is wrong in place of a right one.
static u32 other_word(int lab, const char *name, int is_decision, const u32 *words, size_t at)
{
    const int is_met = lab == 7 && strcmp(name, "clips") == 0 && at % 3 == 0;
    const int goes_on = lab == 7 && strcmp(name, "next_waiting") == 0 &&
                        at % (sizeof(NextWaitingAnswer) / sizeof *words) == 0;
    return is_decision || is_met || goes_on ? words[at] == 0 : words[at] ^ 0x40000000;
}

LAB_TEST(one_wrong_word_is_noticed)
{
    Open open = job_open(*lab, 9);
    Sections answers = right_answers(*lab, &open.file);
    Random random = {10};
    for (size_t s = 0; s < sizeof whole_sections / sizeof *whole_sections; s++) {
        const char *name = whole_sections[s].name;
        size_t n_bytes;
        u32 *words = (u32 *)sections_find_any(&answers, name, &n_bytes);
        if (whole_sections[s].lab != *lab) {
            continue;
        }
        cr_assert_not_null(words);
        size_t n_words = n_bytes / sizeof *words;
        // Of a list only what belongs to it: behind it anything may stand.
        if (strcmp(name, "distribute") == 0) {
            while (words[0] < 3) {
                words += DISTRIBUTE_ROOM;
            }
            n_words = 1 + words[0];
        }
        // Of packed leaves the first one word by word, else some words anywhere.
        const int is_pack = strcmp(name, "pack") == 0;
        // A scene of lab 07 takes long.
        const int is_scene = *lab == 7 && strchr(name, '.') != NULL;
        const size_t n_pack_words =
            (*lab == 6 ? sizeof(PackAnswer3D) : sizeof(PackAnswer)) / sizeof *words;
        const size_t n_tries = is_pack ? n_pack_words : is_scene ? 6 : 40;
        // The work of the picture comes first, then as much room as the margin needs.
        n_words /= strncmp(name, "work.", 5) == 0 ? 4 : 1;
        for (size_t i = 0; i < n_tries; i++) {
            const size_t at =
                is_pack ? i : (size_t)random_integer(&random, 0, (int64_t)n_words - 1);
            if (is_free(*lab, name, words, at)) {
                continue;
            }
            const u32 was = words[at];
            words[at] = other_word(*lab, name, whole_sections[s].is_decision, words, at);
            cr_expect_not(passes_everything(&open, &answers), "%s: word %zu", name, at);
            words[at] = was;
        }
    }
    cr_expect(passes_everything(&open, &answers));
    sections_free(&answers);
    job_close(&open);
}
