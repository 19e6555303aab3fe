// judge/judge_NN: no check passes by answers that are of a wrong size or garbage, nor by right ones
// of which one word is wrong.
#include "jobs_02.h"
#include "jobs_06.h"
#include "judge_07.h"
#include "judged_jobs.h"
#include "random.h"

#include <math.h>

TestSuite(judges_garbage);

// ---- Answers that are not whole -----------------------------------------------------------------

typedef enum Damage { DROPPED, EMPTY, TRUNCATED, OVERSIZED, TWICE, N_DAMAGES } Damage;

// No check is about it: of lab 07's scene with decoys only what is hit is judged.
#define DECOYS_PICTURE "picture.34"
_Static_assert(DECOYS == 34, "the sections of that name");

// Is it one of many that the same code reads, as "picture.3" is, a scene's or a tree's? Then each
// meets one of the faults, the next one another.
static int is_one_of_many(const Section *section)
{
    return strchr(section->name, '.') != NULL;
}

// Whose turn it is of `step` faults. Not just the remainder: a tree may have as many sections.
static int turn(int victim, int step)
{
    return (victim + victim / step) % step;
}

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

LAB_TEST(judges_garbage, a_section_of_a_wrong_size_is_missing)
{
    Open open = job_open(*lab, 2);
    Sections answers = right_answers(lab_names[*lab], open.seed);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    for (int victim = 0; victim < n; victim++) {
        const int step = is_one_of_many(&list[victim]) ? N_DAMAGES : quick(N_DAMAGES, 1);
        for (int damage = turn(victim, step); damage < N_DAMAGES; damage += step) {
            // Where nothing is right: a list of no ids, or that a tree was refused.
            if (list[victim].n_bytes == 0 && (damage == EMPTY || damage == TRUNCATED)) {
                continue;
            }
            if (*lab == 7 && strcmp(list[victim].name, DECOYS_PICTURE) == 0) {
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

LAB_TEST(judges_garbage, garbage_passes_no_check)
{
    Open open = job_open(*lab, 3);
    Sections answers = right_answers(lab_names[*lab], open.seed);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {4};
    for (int kind = quick(*lab % N_KINDS, 0); kind < N_KINDS; kind += quick(N_KINDS, 1)) {
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

// May anything stand in a section? Of the tree that just fits the todo stack only its depth is
// judged, of lab 07's tie what is hit, of its scene with decoys whether one of them is.
static int is_free_section(int lab, const char *name)
{
    return (lab == 6 && strcmp(name, "tree.10.ids") == 0) ||
           (lab == 7 && (strcmp(name, "picture.31") == 0 || strcmp(name, "hits.34") == 0 ||
                         strcmp(name, DECOYS_PICTURE) == 0));
}

// Does every check pass? Asked first is check number *first, the one that did not the last time:
// what is wrong in the same section is mostly seen by the same check, and judging is slow with
// sanitizers.
static int passes_everything(const Open *open, const Sections *answers, int *first)
{
    const int n = open->judge->n_checks;
    for (int i = 0; i < n; i++) {
        const int check = (*first + i) % n;
        if (verdict_on(open, check, answers) != VERDICT_PASSED) {
            *first = check;
            return 0;
        }
    }
    return 1;
}

LAB_TEST(judges_garbage, garbage_in_one_section_is_noticed)
{
    Open open = job_open(*lab, 5);
    Sections answers = right_answers(lab_names[*lab], open.seed);
    Section list[MAX_SECTIONS];
    const int n = list_sections(&answers, list);
    Random random = {6};
    int first = 0;
    for (int victim = 0; victim < n; victim++) {
        // Three kinds a section, or one, others for the next.
        const int step = is_one_of_many(&list[victim]) ? N_KINDS : quick(N_KINDS, 3);
        for (int kind = turn(victim, step); kind < N_KINDS; kind += step) {
            // Zeros are the right picture of a scene without circles.
            if (kind == ZEROS || is_free_section(*lab, list[victim].name)) {
                continue;
            }
            Sections bad = garbled(list, n, victim, kind, &random);
            // Garbage may be what is right: the map of no circle is a zero.
            const int is_same = bad.n_bytes == answers.n_bytes &&
                                memcmp(bad.bytes, answers.bytes, bad.n_bytes) == 0;
            cr_expect(is_same || !passes_everything(&open, &bad, &first), "garbage %d in %s", kind,
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
    {8, "decisions", 1},    {8, "tree.0.ids", 0},
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

LAB_TEST(judges_garbage, one_wrong_word_is_noticed)
{
    Open open = job_open(*lab, 9);
    Sections answers = right_answers(lab_names[*lab], open.seed);
    Random random = {10};
    int first = 0;
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
        const size_t n_tries = is_pack ? n_pack_words : is_scene ? 6 : (size_t)quick(10, 40);
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
            cr_expect_not(passes_everything(&open, &answers, &first), "%s: word %zu", name, at);
            words[at] = was;
        }
    }
    cr_expect(passes_everything(&open, &answers, &first));
    sections_free(&answers);
    job_close(&open);
}
