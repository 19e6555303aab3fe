// Lab 08: whole trees, a property each. Cells are found anew by walking down the student's own
// planes, as in tree3d_judge.h, so that each function blames one step of the building.
//
// Where float or double may round a sphere to either side of a plane, or into a cell or out of it,
// a plane costs something between two numbers, and nobody is blamed for what lies between them.
#include "judge_08.h"

#include "complain.h"
#include "judge_08_rays.h"
#include "kdtree3d_build.h"
#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- The expected tree --------------------------------------------------------------------------

static int choose_expected(const void *pointer, const KdOpenNode *node, KdSplit *split)
{
    const TreeScene3D *scene = pointer;
    const SahNode weighed = {node->box, scene->scene.spheres, node->ids, NULL, node->n_ids};
    if (node->level >= scene->limits.maxDepth ||
        node->n_ids <= (u32)scene->limits.targetElementsPerNode) {
        return 0;
    }
    const SahPlane best = sah_best(&weighed);
    *split = (KdSplit){best.axis, best.pos};
    return best.cost < SAH_TEST * node->n_ids;
}

// ---- Walking down -------------------------------------------------------------------------------

// What a tree's nodes are judged by. Its ids and ranges are sound.
typedef struct Walk {
    const TreeScene3D *scene;
    const KdTree3D *tree;
    BBox3D *cells;            // [n_nodes]
    int *levels;              // [n_nodes]
    u32 *ids;                 // [n_spheres], of the node at hand
    unsigned char *may_lack;  // [n_spheres]
} Walk;

static void *room(size_t n, size_t n_bytes)
{
    void *array = calloc(n + 1, n_bytes);
    if (array == NULL) {
        complain("grade: no memory for a tree");
        exit(2);
    }
    return array;
}

static Walk walk_begin(const TreeScene3D *scene, const KdTree3D *tree)
{
    const size_t n_spheres = (size_t)scene->scene.n_spheres;
    Walk walk = {scene,
                 tree,
                 room(tree->n_nodes, sizeof *walk.cells),
                 room(tree->n_nodes, sizeof *walk.levels),
                 room(n_spheres, sizeof *walk.ids),
                 room(n_spheres, sizeof *walk.may_lack)};
    walk.cells[0] = tree->bounds;
    walk.levels[0] = 1;
    return walk;
}

static void walk_end(Walk *walk)
{
    free(walk->cells);
    free(walk->levels);
    free(walk->ids);
    free(walk->may_lack);
}

// Come to node `id`: its children's cells and levels are known from now on. Returns the node with
// the spheres that overlap its cell, or may do so.
static SahNode walk_to(Walk *walk, u32 id)
{
    const KdNode3 node = walk->tree->nodes[id];
    const BBox3D cell = walk->cells[id];
    if (node.split_axis != KD_LEAF) {
        walk->cells[node.first] = walk->cells[node.first + 1] = cell;
        walk->cells[node.first].max[node.split_axis] = node.split_pos;
        walk->cells[node.first + 1].min[node.split_axis] = node.split_pos;
        walk->levels[node.first] = walk->levels[node.first + 1] = walk->levels[id] + 1;
    }
    const Sphere *spheres = walk->scene->scene.spheres;
    u32 n_ids = 0;
    for (u32 i = 0; i < (u32)walk->scene->scene.n_spheres; i++) {
        const SphereInCell is = tree3d_judge_sphere(spheres[i], cell);
        walk->ids[n_ids] = i;
        walk->may_lack[n_ids] = is == SPHERE_EITHER;
        n_ids += is != SPHERE_OUTSIDE;
    }
    return (SahNode){cell, spheres, walk->ids, walk->may_lack, n_ids};
}

// ---- Ties ---------------------------------------------------------------------------------------

// What a node may be where costs are known but for rounding.
typedef struct Choice {
    int may_be_leaf, may_be_split;
    SahPlane best;
} Choice;

static Choice choice_at(const TreeScene3D *scene, const SahNode *node, int level)
{
    const KdTreeLimits limits = scene->limits;
    const u32 target = (u32)limits.targetElementsPerNode;
    u32 n_least = 0;
    for (u32 i = 0; i < node->n_ids; i++) {
        n_least += !node->may_lack[i];
    }
    const SahPlane best = sah_best(node);
    return (Choice){level >= limits.maxDepth || n_least <= target ||
                        best.most * (1 + SAH_COST_TOLERANCE) >= SAH_TEST * n_least,
                    level < limits.maxDepth && node->n_ids > target &&
                        best.least * (1 - SAH_COST_TOLERANCE) < SAH_TEST * node->n_ids,
                    best};
}

// May right solutions differ in what they do with a node of the expected tree?
static int has_tie(const TreeScene3D *scene)
{
    Walk walk = walk_begin(scene, &scene->tree);
    int found = 0;
    for (u32 id = 0; !found && id < scene->tree.n_nodes; id++) {
        const SahNode node = walk_to(&walk, id);
        const Choice choice = choice_at(scene, &node, walk.levels[id]);
        found = choice.may_be_split && (choice.may_be_leaf || sah_is_tied(&node, &choice.best));
    }
    walk_end(&walk);
    return found;
}

// The steps of lab 06 are its solution's: what is judged here are the planes.
int tree_expect_08(TreeScene3D *scene)
{
    const KdSteps steps = {"grade",         choose_expected, scene, distribute_spheres,
                           pack_leaf_range, fits_todo};
    const u32 n_spheres = (u32)scene->scene.n_spheres;
    if (tree3d_grow(&steps, scene->scene.spheres, n_spheres,
                    tree3d_expected_box(scene->scene.spheres, n_spheres), &scene->tree) != 0) {
        return -1;
    }
    scene->is_tied = has_tie(scene);
    return 0;
}

// ---- The properties -----------------------------------------------------------------------------

// What must hold before a tree can be followed.
static Diagnosis judge_soundness(const TreeScene3D *scene, const KdTree3D *own)
{
    Diagnosis wrong = tree3d_judge_packing(scene, own);
    wrong = wrong.found != NULL ? wrong : tree3d_judge_depth(scene, own);
    return wrong;
}

// Is the plane of an inner node one of its cell, and is none cheaper?
static Diagnosis judge_plane(const char *where, const SahNode *node, KdNode3 found)
{
    const Words plane =
        words("%c = %s", "xyz"[found.split_axis], words_float(found.split_pos).text);
    const int number = sah_plane_number(node->box, found.split_axis, found.split_pos);
    if (number == 0) {
        return diagnosis_new("%s, cell %s: found a split at %s, expected one of the %d candidate "
                             "planes of an axis",
                             where, words_box3d(node->box).text, plane.text, SAH_BINS - 1);
    }
    const SahPlane own = sah_weigh(node, found.split_axis, number);
    const SahPlane best = sah_best(node);
    // All planes of a cell without area are as good.
    if (best.cost == INFINITY || own.least <= best.most * (1 + 2 * SAH_COST_TOLERANCE)) {
        return NOTHING_WRONG;
    }
    return diagnosis_new("%s, cell %s with %u sphere%s: found a split at %s, which costs %.6g, "
                         "expected %c = %s, which costs %.6g",
                         where, words_box3d(node->box).text, node->n_ids, plural(node->n_ids),
                         plane.text, own.cost, "xyz"[best.axis], words_float(best.pos).text,
                         best.cost);
}

Diagnosis tree_judge_splits_08(const TreeScene3D *scene, const KdTree3D *own)
{
    Diagnosis wrong = tree3d_judge_bounds(scene, own);
    wrong = wrong.found != NULL ? wrong : judge_soundness(scene, own);
    if (wrong.found != NULL) {
        return wrong;
    }
    Walk walk = walk_begin(scene, own);
    for (u32 id = 0; wrong.found == NULL && id < own->n_nodes; id++) {
        const SahNode node = walk_to(&walk, id);
        if (own->nodes[id].split_axis != KD_LEAF) {
            wrong = judge_plane(words("%s: node %u", scene->title, id).text, &node, own->nodes[id]);
        }
    }
    walk_end(&walk);
    return wrong.found != NULL ? wrong : tree3d_judge_overlap(scene, own);
}

// Is a node a leaf where it must be, and nowhere else?
static Diagnosis judge_decision(const TreeScene3D *scene, const SahNode *node, int level, u32 id,
                                int is_leaf)
{
    const Choice choice = choice_at(scene, node, level);
    if (is_leaf ? choice.may_be_leaf : choice.may_be_split) {
        return NOTHING_WRONG;
    }
    return diagnosis_new("%s, maxDepth %d, targetElementsPerNode %u: node %u on level %d with %u "
                         "sphere%s, where a leaf costs %g and the best split %.6g, is %s, expected "
                         "%s",
                         scene->title, scene->limits.maxDepth,
                         (u32)scene->limits.targetElementsPerNode, id, level, node->n_ids,
                         plural(node->n_ids), SAH_TEST * node->n_ids, choice.best.cost,
                         is_leaf ? "a leaf" : "split", is_leaf ? "it to be split" : "a leaf");
}

Diagnosis tree_judge_leaves_08(const TreeScene3D *scene, const KdTree3D *own)
{
    Diagnosis wrong = judge_soundness(scene, own);
    if (wrong.found != NULL) {
        return wrong;
    }
    Walk walk = walk_begin(scene, own);
    for (u32 id = 0; wrong.found == NULL && id < own->n_nodes; id++) {
        const SahNode node = walk_to(&walk, id);
        wrong =
            judge_decision(scene, &node, walk.levels[id], id, own->nodes[id].split_axis == KD_LEAF);
    }
    walk_end(&walk);
    return wrong;
}

// Two right trees differ where costs are equal up to rounding. Such ties are between planes that
// are as good for the rays on average, and not for each: a tenth is for that.
#define WORK_LIMIT 1.1

Diagnosis tree_judge_work_08(const TreeScene3D *scene, const KdTree3D *own)
{
    const Diagnosis wrong = judge_soundness(scene, own);
    if (wrong.found != NULL) {
        return wrong;
    }
    const SearchWork expected = search_work_08(&scene->scene, &scene->tree);
    const SearchWork found = search_work_08(&scene->scene, own);
    const double cost = SAH_TRAVERSAL * found.n_nodes + SAH_TEST * found.n_tests;
    const double expected_cost = SAH_TRAVERSAL * expected.n_nodes + SAH_TEST * expected.n_tests;
    return cost <= WORK_LIMIT * expected_cost
               ? NOTHING_WRONG
               : diagnosis_new("%s: a ray of its picture asks %.2f spheres and visits %.2f inner "
                               "nodes on average, expected about %.2f and %.2f: the tree is worse",
                               scene->title, found.n_tests, found.n_nodes, expected.n_tests,
                               expected.n_nodes);
}
