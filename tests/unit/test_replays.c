// judge/shared/replay.h and what judge_02_alone.c and judge_06_alone.c make of it: an answer tried
// alone passes with right answers, and with nothing missing, cut off or wrong.
//
// The right answers come from the solutions of the labs, and lists from the rules of lab 02's
// stand-in: its squares are written once more here.
#include "judge.h"
#include "kdtree2d_build.h"
#include "kdtree3d_build.h"
#include "manifest.h"
#include "right_answers_sections.h"
#include "surroundings.h"

#include <criterion/parameterized.h>

TestSuite(replays);

static const char *const lab_names[] = {"02-kdtree-2d-build", "06-kdtree-3d-build"};

// ---- Right answers ------------------------------------------------------------------------------

// The job's section, NULL when it does not ask for that, and how many elements it has.
static const void *asked(const Sections *job, const char *name, size_t element_size, size_t *n)
{
    size_t n_bytes = 0;
    const void *bytes = sections_find_any(job, name, &n_bytes);
    *n = bytes != NULL ? n_bytes / element_size : 0;
    return bytes;
}

static void answer_leaves(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const LeafJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = is_leaf(in[i].level, in[i].n_circles, in[i].n_failed,
                         (KdTreeLimits){in[i].maxDepth, in[i].targetElementsPerNode});
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static void answer_halves(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BBox2D *in = asked(job, name, sizeof *in, &n);
    BBox2D *out = calloc(2 * n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        split_box(in[i], &out[2 * i], &out[2 * i + 1]);
    }
    answer(writer, name, out, 2 * n * sizeof *out);
    free(out);
}

static void answer_planes(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BBox3D *in = asked(job, name, sizeof *in, &n);
    KdSplit *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = choose_split(in[i]);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static void answer_circles(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const BoxOverlapJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = circle_overlaps_box(in[i].circle, in[i].box);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static void answer_spheres(Writer *writer, const Sections *job, const char *name)
{
    size_t n;
    const SphereBoxJob *in = asked(job, name, sizeof *in, &n);
    i32 *out = calloc(n + 1, sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = sphere_overlaps_box(in[i].sphere, in[i].box);
    }
    answer(writer, name, out, n * sizeof *out);
    free(out);
}

static void answer_levels(Writer *writer, const Sections *job)
{
    size_t n;
    const u32 *highest = asked(job, "todo", sizeof *highest, &n);
    const i32 *levels = asked(job, "replay.todo", sizeof *levels, &n);
    i32 *out = calloc(n + *highest, sizeof *out);
    for (u32 level = 1; level <= *highest; level++) {
        out[level - 1] = fits_todo((int)level);
    }
    answer(writer, "todo", out, *highest * sizeof *out);
    for (size_t i = 0; i < n; i++) {
        out[i] = fits_todo(levels[i]);
    }
    answer(writer, "replay.todo", out, n * sizeof *out);
    free(out);
}

// ---- Lists, by the stand-in ---------------------------------------------------------------------

// Are two intervals in touch on an axis?
static int in_touch(float centre, float reach, float min, float max)
{
    return centre + reach >= min && centre - reach <= max;
}

// The list of a child with its number in front, as the probe has it.
//   out[n_room]   where it goes, and what stays as it was
static void list_child(const Circle *circles, const u32 *ids, u32 n_ids, BBox2D cell, u32 *out,
                       size_t n_room)
{
    u32 n = 0;
    for (size_t i = 0; i < n_room; i++) {
        out[i] = UNTOUCHED;
    }
    for (u32 i = 0; i < n_ids; i++) {
        const Circle c = circles[ids[i]];
        if (in_touch(c.x, c.radius, cell.minX, cell.maxX) &&
            in_touch(c.y, c.radius, cell.minY, cell.maxY)) {
            out[1 + n++] = ids[i];
        }
    }
    out[0] = n;
}

static void answer_lists(Writer *writer, const Sections *job)
{
    size_t n, n_other;
    const DistributeJob *nodes = asked(job, "distribute", sizeof *nodes, &n);
    u32(*rooms)[DISTRIBUTE_ROOM] = calloc(n, sizeof *rooms);
    for (size_t i = 0; i < n; i++) {
        const Circle *circles =
            asked(job, numbered("scene", DISTRIBUTE_SCENE, "circles"), 1, &n_other);
        list_child(circles, nodes[i].ids, nodes[i].n_ids, nodes[i].child, rooms[i],
                   DISTRIBUTE_ROOM);
    }
    answer(writer, "distribute", rooms, n * sizeof *rooms);
    free(rooms);

    const ReplayList *lists = asked(job, "replay.lists", sizeof *lists, &n);
    const BBox2D *cells = asked(job, "replay.cells", sizeof *cells, &n_other);
    cr_assert_eq(n, n_other);
    const u32 *ids = asked(job, "replay.ids", sizeof *ids, &n_other);
    size_t n_answered = 0;
    for (size_t i = 0; i < n; i++) {
        cr_assert_leq(lists[i].first_id + lists[i].n_ids, n_other);
        n_answered += REPLAY_ROOM(lists[i].n_ids);
    }
    u32 *out = calloc(n_answered, sizeof *out), *next = out;
    for (size_t i = 0; i < n; i++) {
        const Circle *circles =
            asked(job, numbered("scene", (int)lists[i].scene, "circles"), 1, &n_other);
        list_child(circles, ids + lists[i].first_id, lists[i].n_ids, cells[i], next,
                   REPLAY_ROOM(lists[i].n_ids));
        next += REPLAY_ROOM(lists[i].n_ids);
    }
    answer(writer, "replay.lists", out, n_answered * sizeof *out);
    free(out);
}

// ---- Leaves -------------------------------------------------------------------------------------

// Of the checks of packing only that of whole trees is answered: the others are in test_judges.
static void answer_packed(Writer *writer, const Sections *job, int is_3d)
{
    size_t n_trees, n, n_ids, at = 0;
    const ReplayTree *trees = asked(job, "replay.trees", sizeof *trees, &n_trees);
    const ReplayList *leaves = asked(job, "replay.leaves", sizeof *leaves, &n);
    const u32 *ids = asked(job, "replay.ids", sizeof *ids, &n_ids);
    for (u32 k = 0; k < n_trees; k++) {
        const size_t room = (size_t)trees[k].n_entries + REPLAY_GUARD;
        NodeRel *relations = calloc(trees[k].n_nodes, sizeof *relations);
        u8 *flags = calloc(trees[k].n_nodes, sizeof *flags);
        KdNode3 *nodes = calloc(trees[k].n_nodes, sizeof *nodes);
        u32 *map = calloc(room, sizeof *map);
        for (u32 id = 0; id < trees[k].n_nodes; id++) {
            relations[id].id = id;
            flags[id] = INNER;
            nodes[id].first = nodes[id].n_spheres = UNTOUCHED;
        }
        for (size_t i = 0; i < room; i++) {
            map[i] = UNTOUCHED;
        }
        KdTree2D flat = {relations, flags, NULL, map, trees[k].n_nodes, 0};
        KdTree3D deep = {.nodes = nodes, .sphere_ids = map, .n_nodes = trees[k].n_nodes};
        for (; at < n && leaves[at].scene == k; at++) {
            const ReplayList leaf = leaves[at];
            if (is_3d) {
                pack_leaf_range(&deep, leaf.node, ids + leaf.first_id, leaf.n_ids);
            } else {
                pack_leaf(&flat, leaf.node, ids + leaf.first_id, leaf.n_ids);
            }
        }
        const u32 end = is_3d ? deep.n_sphere_ids : flat.n_map;
        answer(writer, numbered("packed", (int)k, NULL), &end, sizeof end);
        answer(writer, numbered("packed", (int)k, "nodes"), is_3d ? (void *)nodes : relations,
               trees[k].n_nodes * sizeof(NodeRel));
        if (!is_3d) {
            answer(writer, numbered("packed", (int)k, "flags"), flags, trees[k].n_nodes);
        }
        answer(writer, numbered("packed", (int)k, "map"), map, room * sizeof *map);
        free(relations);
        free(flags);
        free(nodes);
        free(map);
    }
    cr_assert_eq(at, n);
}
_Static_assert(sizeof(NodeRel) == sizeof(KdNode3), "answered alike");

// ---- Jobs ---------------------------------------------------------------------------------------

// The job of a task alone, and right answers to it.
typedef struct Alone {
    const Judge *judge;
    const char *task;
    Job *job;
    Sections file;
    Sections answers;
} Alone;

static Sections right_answers_to(const Sections *job, int is_3d)
{
    Writer writer;
    size_t n;
    writer_open(&writer);
    if (asked(job, "replay.leaf", 1, &n)) {
        answer_leaves(&writer, job, "leaves");
        answer_leaves(&writer, job, "replay.leaf");
    } else if (asked(job, "replay.split", 1, &n)) {
        (is_3d ? answer_planes : answer_halves)(&writer, job, "splits");
        (is_3d ? answer_planes : answer_halves)(&writer, job, "replay.split");
    } else if (asked(job, "replay.overlap", 1, &n)) {
        (is_3d ? answer_spheres : answer_circles)(&writer, job, "overlaps");
        (is_3d ? answer_spheres : answer_circles)(&writer, job, "replay.overlap");
    } else if (asked(job, "replay.lists", 1, &n)) {
        answer_lists(&writer, job);
    } else if (asked(job, "replay.leaves", 1, &n)) {
        answer_packed(&writer, job, is_3d);
    } else {
        answer_levels(&writer, job);
    }
    return writer_close(&writer);
}

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

TASK_TEST(a_job_alone_is_small_and_asks_for_no_tree)
{
    Alone alone = alone_open(at->lab, at->task, 1);
    size_t n_bytes;
    cr_expect_lt(alone.file.n_bytes, 2u << 20, "%s: %zu bytes", at->task, alone.file.n_bytes);
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

// May anything stand in this word? A leaf's split_pos; behind a list, where a node's ids have room;
// and any number that is not 0 is a yes.
static int is_free(const Case *at, const Word *word, size_t i)
{
    const int is_list = strcmp(word->name, "distribute") == 0 || strstr(word->name, "lists");
    const int is_3d_node = at->lab == 1 && strstr(word->name, ".nodes") != NULL;
    return (is_list && word->words[i] == UNTOUCHED) ||
           (is_3d_node && i % 4 == 0 && word->words[i + 1] == KD_LEAF);
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
            if (is_free(at, &word, i)) {
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
