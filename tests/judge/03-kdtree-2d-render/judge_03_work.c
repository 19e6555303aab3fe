// Lab 03: the calls that the kernel counts for each pixel. See judge_03.h.
//
// What is said of them has to be true of every pixel, in all scenes of the check: one pixel's count
// may be that of many a mistake.
#include "judge_03.h"

#include "job_work.h"
#include "message.h"
#include "words.h"

#include <stdlib.h>

// ---- Mistakes -----------------------------------------------------------------------------------

// The calls of a pixel.
typedef struct Calls {
    u32 found, expected;
    int are_of_the_leaf;  // the pixel ended in its leaf, or they are too many for any way
} Calls;

typedef struct KnownCalls {
    const char *says;
    int (*fit)(Calls calls);
} KnownCalls;
#define CALLS(name, expression, sentence)                                                          \
    static int name##_fit(Calls calls)                                                             \
    {                                                                                              \
        const u32 found = calls.found, n = calls.expected;                                         \
        (void)found, (void)n;                                                                      \
        return expression;                                                                         \
    }                                                                                              \
    static const KnownCalls name = {sentence, name##_fit};

CALLS(hidden, found == 0,
      "either the function was not called, or not with &work: work that is hidden cannot be "
      "counted")

CALLS(root_asked, found == n || n == 0, "the root is a leaf, and there is no step to take")
CALLS(steps_twice, found == 2 * n && calls.are_of_the_leaf, "it was called twice for each node")
CALLS(steps_again, found >= n && calls.are_of_the_leaf, "some nodes were asked more than once")

CALLS(cut_8, found == (n & 0xff), "that is what 8 bits hold of it")
CALLS(cut_16, found == (n & 0xffff), "that is what 16 bits hold of it")
CALLS(none_asked, found == n || n == 0, "an empty list has no circle to ask")
CALLS(asked_twice, found == 2 * n, "each was asked twice")
CALLS(asked_more, found >= n, "some were asked more than once, or circles that are not in the list")

CALLS(asked_fewer, found <= n && calls.are_of_the_leaf, "circles of the list were not asked")

// The special ones come first.
static const KnownCalls *const known_steps[] = {&root_asked, &hidden, &steps_twice, &steps_again,
                                                NULL};
static const KnownCalls *const known_tests[] = {
    &hidden, &cut_8, &cut_16, &none_asked, &asked_twice, &asked_more, &asked_fewer, NULL};

// ---- What is expected ---------------------------------------------------------------------------

// How many nodes above the leaf: every node whose cell holds the pixel lies on the way.
static u32 steps_to_leaf(const KdTree2D *tree, int x, int y)
{
    u32 steps = 0;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        steps += tree->nodes_flag[id] != LEAF && cell_holds(tree->nodes_BBox[id], x, y);
    }
    return steps;
}

// How many inner nodes the longest path from the root has. Children have higher ids than their
// parent.
static u32 longest_path(const KdTree2D *tree)
{
    u32 longest = 0, *above = calloc(tree->n_nodes, sizeof *above);
    for (u32 id = 0; above != NULL && id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        if (tree->nodes_flag[id] != LEAF) {
            above[node.lChild] = above[node.rChild] = above[id] + 1;
        }
        longest = above[id] > longest ? above[id] : longest;
    }
    const int is_known = above != NULL;
    free(above);
    return is_known ? longest : UINT32_MAX;
}

// A scene that is judged: its pixels all ended in their leaves, or its tree has no path longer than
// so many nodes.
typedef struct Judged {
    const JobScene *scene;
    int is_drawn;
    u32 longest;
} Judged;

static Calls steps_of(const Judged *judged, int x, int y, Work found)
{
    const u32 n = found.n_nodes_visited;
    return (Calls){n, steps_to_leaf(&judged->scene->tree, x, y),
                   judged->is_drawn || n > judged->longest};
}

static Calls tests_of(const Judged *judged, int x, int y, Work found)
{
    const KdTree2D *tree = &judged->scene->tree;
    const u32 leaf = leaf_at(tree, x, y);
    return (Calls){found.n_tests,
                   tree->mapNode2Circles[tree->nodes_Relations[leaf].circleMapOffset],
                   judged->is_drawn};
}

static char *describe_steps(const char *where, Calls calls)
{
    return message_new("%s: getContainingChild was called %u time%s, expected %u, once for each "
                       "inner node on the way to the leaf",
                       where, calls.found, plural(calls.found), calls.expected);
}

static char *describe_tests(const char *where, Calls calls)
{
    return message_new("%s: overlaps_N_Nearer was called %u time%s, but the leaf lists %u circle%s",
                       where, calls.found, plural(calls.found), calls.expected,
                       plural(calls.expected));
}

// ---- Judging ------------------------------------------------------------------------------------

typedef struct JudgeCalls {
    Calls (*of)(const Judged *judged, int x, int y, Work found);
    char *(*describe)(const char *where, Calls calls);
    const KnownCalls *const *known;  // NULL behind the last
} JudgeCalls;

// What was found: the first wrong pixel, NULL where none is, and which mistakes are not the cause,
// a bit for each.
typedef struct Found {
    char *wrong;
    unsigned excluded;
} Found;

// Take a pixel into account. Where its count is right, that may exclude a mistake, too.
static void add_pixel(const JudgeCalls *judge, const JobScene *scene, int x, int y, Calls calls,
                      Found *found)
{
    if (found->wrong == NULL && calls.found != calls.expected) {
        const Words where = words("%s: pixel (%d, %d)", scene->picture.title, x, y);
        found->wrong = judge->describe(where.text, calls);
    }
    for (int k = 0; judge->known[k] != NULL; k++) {
        found->excluded |= judge->known[k]->fit(calls) ? 0 : 1u << k;
    }
}

// Take scene K into account. In a large picture every seventh pixel each way is plenty: the tree is
// asked node by node. In a small one a leaf may be a few pixels. Returns 0, or -1 where its work is
// missing.
static int add_scene(const JudgeCalls *judge, const Job03 *job, int k, const Sections *answers,
                     Found *found)
{
    const JobScene *scene = &job->scenes[k];
    const int width = scene->scene.width, height = scene->scene.height;
    const Work *work = job_work_find(&scene->picture, k, answers);
    const int step = width * height > 10000 ? 7 : 1;
    const ProbeImage own = job_picture_answer(&scene->picture, k, answers);
    const int is_drawn =
        own.pixels != NULL && (picture_is_right(own, &scene->picture.expected) ||
                               ends_in_leaves_03(job, k, answers));  // beside stubs
    const Judged judged = {scene, is_drawn, longest_path(&scene->tree)};
    for (int y = 0; work != NULL && y < height; y += step) {
        for (int x = 0; x < width; x += step) {
            if (cell_holds(scene->tree.nodes_BBox[0], x, y)) {
                add_pixel(judge, scene, x, y, judge->of(&judged, x, y, work[y * width + x]), found);
            }
        }
    }
    return work != NULL ? 0 : -1;
}

static Verdict judge_scenes(const JudgeCalls *judge, const Job03 *job, const int scenes[], int n,
                            const Sections *answers)
{
    Found found = {0};
    Cause cause = {0};
    for (int i = 0; i < n; i++) {
        if (add_scene(judge, job, scenes[i], answers, &found) != 0) {
            free(found.wrong);
            return verdict_missing;
        }
    }
    for (int k = 0; cause.says == NULL && judge->known[k] != NULL; k++) {
        cause.says = (found.excluded >> k & 1) == 0 ? judge->known[k]->says : NULL;
    }
    return verdict_of(found.wrong != NULL ? diagnosis_of(found.wrong, cause) : NOTHING_WRONG);
}

Verdict judge_descent_work_03(const void *job, const Sections *answers)
{
    static const int scenes[] = {WIDE, ROOT_IS_LEAF};
    static const JudgeCalls steps = {steps_of, describe_steps, known_steps};
    return judge_scenes(&steps, job, scenes, COUNT(scenes), answers);
}

Verdict judge_leaf_work_03(const void *job, const Sections *answers)
{
    static const int scenes[] = {WIDE, EMPTY_LEAVES, ROOT_IS_LEAF, LONG_LIST};
    static const JudgeCalls tests = {tests_of, describe_tests, known_tests};
    return judge_scenes(&tests, job, scenes, COUNT(scenes), answers);
}
