// Tree invariants in 3D, checked in double precision. What one call of a student's function must
// give is in tree3d_judge_steps.c, how the tree is packed in tree3d_judge_packing.c.
#include "tree3d_judge.h"

#include "complain.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "tree3d_walk.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

int tree3d_judge_answer(int k, const Sections *answers, KdTree3D *own)
{
    const TreeAnswer3D *answer = job_section_find(answers, "tree", k, sizeof *answer);
    if (answer == NULL || answer->n_nodes == 0) {
        return 0;
    }
    const void *nodes =
        job_part_find(answers, "tree", k, "nodes", answer->n_nodes * sizeof(KdNode3));
    const void *ids = job_part_find(answers, "tree", k, "ids", answer->n_sphere_ids * sizeof(u32));
    // The judge only reads: the casts take no const away that matters.
    *own = (KdTree3D){answer->bounds, (KdNode3 *)nodes, (u32 *)ids, answer->n_nodes,
                      answer->n_sphere_ids};
    return nodes != NULL && ids != NULL;
}

// How many nodes are looked at where each is held against every sphere. As long as ids are
// breadth-first, the first wrong node is among as many as are expected, or a few more where
// rounding splits another one; a million more would only take hours.
static u32 n_judged(const TreeScene3D *scene, const KdTree3D *own)
{
    const u32 most = 2 * scene->tree.n_nodes;
    return own->n_nodes < most ? own->n_nodes : most;
}

// How many spheres a list must have at least and may have at most.
typedef struct Count {
    u32 least, most;
} Count;

static Count count_spheres(const TreeScene3D *scene, BBox3D cell)
{
    Count count = {0, 0};
    for (int i = 0; i < scene->scene.n_spheres; i++) {
        const SphereInCell is = tree3d_judge_sphere(scene->scene.spheres[i], cell);
        count.least += is == SPHERE_INSIDE;
        count.most += is != SPHERE_OUTSIDE;
    }
    return count;
}

void tree3d_describe_box(const void *input, char *words, size_t n_bytes)
{
    const BBox3D *box = input;
    snprintf(words, n_bytes, "box x [%g, %g] y [%g, %g] z [%g, %g]", (double)box->min[0],
             (double)box->max[0], (double)box->min[1], (double)box->max[1], (double)box->min[2],
             (double)box->max[2]);
}

// ---- The properties ---------------------------------------------------------------------------

Diagnosis tree3d_judge_bounds(const TreeScene3D *scene, const KdTree3D *own)
{
    const BBox3D expected = tree3d_expected_box(scene->scene.spheres, (u32)scene->scene.n_spheres);
    int is_right = 1;
    for (int axis = 0; axis < 3; axis++) {
        is_right = is_right && own->bounds.min[axis] == expected.min[axis] &&
                   own->bounds.max[axis] == expected.max[axis];
    }
    return is_right ? NOTHING_WRONG
                    : diagnosis_new("%s: bounds: found %s, expected %s", scene->title,
                                    words_box3d(own->bounds).text, words_box3d(expected).text);
}

Diagnosis tree3d_judge_splits(const TreeScene3D *scene, const KdTree3D *own)
{
    const u32 n = n_judged(scene, own), n_expected = scene->tree.n_nodes / 2;
    Walk walk = walk_down(own);
    Diagnosis wrong = NOTHING_WRONG;
    u32 n_splits = 0;
    for (u32 id = 0; wrong.found == NULL && id < n; id++) {
        const KdNode3 node = own->nodes[id];
        const Words node_words = words("%s: node %u", scene->title, id);
        const char *where = node_words.text;
        if (walk.levels[id] == 0 || is_leaf_node(own, id)) {
            continue;
        }
        wrong = tree3d_judge_axis(where, walk.cells[id], node.split_axis);
        if (wrong.found == NULL && !has_children(own, id)) {
            wrong = diagnosis_new("%s: an inner node, but its children are %u and %u of %u nodes",
                                  where, node.first, node.first + 1, own->n_nodes);
        }
        if (wrong.found == NULL) {
            wrong = tree3d_judge_middle(where, walk.cells[id], node.split_axis, node.split_pos);
        }
        n_splits++;
    }
    walk_free(&walk);
    // Rounding may make it a few more or less. Far less show nothing of choose_split().
    if (wrong.found == NULL && n_splits < n_expected / 2 + n_expected % 2) {
        return diagnosis_new("%s: from the root on, found %u node%s with children, expected %u",
                             scene->title, n_splits, plural(n_splits), n_expected);
    }
    return wrong;
}

// Compare one leaf's list with the spheres that overlap its cell.
//   listed   [n_spheres], all zero; and again afterwards
static Diagnosis judge_leaf(const TreeScene3D *scene, const KdTree3D *own, u32 id, BBox3D cell,
                            unsigned char *listed)
{
    const u32 *ids = leaf_ids(own, id);
    const u32 n_spheres = (u32)scene->scene.n_spheres;
    if (ids == NULL) {
        return bad_range(scene, own, id);
    }
    if (own->nodes[id].n_spheres > n_spheres) {
        return diagnosis_new("%s: leaf %u lists %u sphere%s, but the scene has %u", scene->title,
                             id, own->nodes[id].n_spheres, plural(own->nodes[id].n_spheres),
                             n_spheres);
    }
    for (u32 i = 0; i < own->nodes[id].n_spheres; i++) {
        if (ids[i] < n_spheres) {
            listed[ids[i]] = 1;
        }
    }
    Diagnosis wrong = NOTHING_WRONG;
    for (u32 i = 0; i < n_spheres; i++) {
        const SphereInCell is = tree3d_judge_sphere(scene->scene.spheres[i], cell);
        if (wrong.found == NULL && is != SPHERE_EITHER && listed[i] != (is == SPHERE_INSIDE)) {
            char *found = message_new(
                "%s: leaf %u, %s: sphere %u at %s %s, but the leaf %s it", scene->title, id,
                words_box3d(cell).text, i, words_sphere(scene->scene.spheres[i]).text,
                is == SPHERE_INSIDE ? "overlaps its cell" : "does not overlap it",
                listed[i] ? "lists" : "does not list");
            const Mistake mistake = listed[i] ? MISTAKE_NONE : MISTAKE_MISSING_IN_CELL;
            wrong = diagnosis_of(found, (Cause){.mistake = mistake});
        }
        listed[i] = 0;
    }
    return wrong;
}

Diagnosis tree3d_judge_overlap(const TreeScene3D *scene, const KdTree3D *own)
{
    const u32 n = n_judged(scene, own);
    Walk walk = walk_down(own);
    unsigned char *listed = calloc((size_t)scene->scene.n_spheres + 1, 1);
    if (listed == NULL) {
        complain("grade: no memory for a list");
        exit(2);
    }
    Diagnosis wrong = NOTHING_WRONG;
    u64 n_listed = 0;
    for (u32 id = 0; wrong.found == NULL && id < n; id++) {
        if (walk.levels[id] > 0 && is_leaf_node(own, id)) {
            wrong = judge_leaf(scene, own, id, walk.cells[id], listed);
            n_listed += own->nodes[id].n_spheres;
        } else if (walk.levels[id] > 0 && !has_children(own, id)) {
            wrong = diagnosis_new("%s: node %u: split_axis is %u and first %u of %u nodes, "
                                  "expected KD_LEAF (%d), or an axis and its children: no search "
                                  "comes to its spheres",
                                  scene->title, id, own->nodes[id].split_axis, own->nodes[id].first,
                                  own->n_nodes, KD_LEAF);
        }
    }
    // Every cell may be empty where the root's own is: a tree of no use all the same.
    if (wrong.found == NULL && n_listed == 0 && scene->scene.n_spheres > 0) {
        wrong = diagnosis_new("%s: found no sphere in any leaf, but the scene has %d", scene->title,
                              scene->scene.n_spheres);
    }
    free(listed);
    walk_free(&walk);
    return wrong;
}

// One leaf's list by itself.
static Diagnosis judge_list(const TreeScene3D *scene, const KdTree3D *own, u32 id)
{
    const u32 *ids = leaf_ids(own, id);
    if (ids == NULL) {
        return bad_range(scene, own, id);
    }
    for (u32 i = 0; i < own->nodes[id].n_spheres; i++) {
        if (ids[i] >= (u32)scene->scene.n_spheres) {
            return diagnosis_new("%s: leaf %u lists sphere %u, but the scene has %d", scene->title,
                                 id, ids[i], scene->scene.n_spheres);
        }
    }
    return judge_order(scene, own, id);
}

// Of the splits above node `id`, how many failed at least and at most: what its children have, too,
// after its own split.
static Count count_failed(const TreeScene3D *scene, const Walk *walk, const KdTree3D *own, u32 id,
                          Count failed)
{
    const u32 child = own->nodes[id].first;
    const Count parent = count_spheres(scene, walk->cells[id]);
    const Count lower = count_spheres(scene, walk->cells[child]);
    const Count higher = count_spheres(scene, walk->cells[child + 1]);
    failed.least += (u32)oracle_split_fails(parent.most, lower.least, higher.least);
    failed.most += (u32)oracle_split_fails(parent.least, lower.most, higher.most);
    return failed;
}

// Is a node a leaf where the limits say so, and nowhere else?
//   failed   how many splits above it failed
static Diagnosis judge_limits(const TreeScene3D *scene, const KdTree3D *own, u32 id, int level,
                              BBox3D cell, Count failed)
{
    const KdTreeLimits limits = scene->limits;
    const u32 target = (u32)limits.targetElementsPerNode;
    const Count count = count_spheres(scene, cell);
    const int is_leaf = is_leaf_node(own, id);
    const int may_be_leaf =
        level >= limits.maxDepth || count.least <= target || failed.most >= MAX_FAILED_SPLITS;
    const int may_be_split =
        level < limits.maxDepth && count.most > target && failed.least < MAX_FAILED_SPLITS;
    if (is_leaf ? may_be_leaf : may_be_split) {
        return NOTHING_WRONG;
    }
    return diagnosis_new("%s, maxDepth %d, targetElementsPerNode %u: node %u on level %d with %u "
                         "spheres, below %u failed splits, is %s, expected %s",
                         scene->title, limits.maxDepth, target, id, level, count.least,
                         failed.least, is_leaf ? "a leaf" : "split",
                         is_leaf ? "it to be split" : "a leaf");
}

Diagnosis tree3d_judge_lists(const TreeScene3D *scene, const KdTree3D *own)
{
    const u32 n = n_judged(scene, own);
    Walk walk = walk_down(own);
    Count *failed = calloc((size_t)own->n_nodes + 1, sizeof *failed);
    if (failed == NULL) {
        complain("grade: no memory for a tree");
        exit(2);
    }
    Diagnosis wrong = NOTHING_WRONG;
    for (u32 id = 0; wrong.found == NULL && id < n; id++) {
        if (is_leaf_node(own, id)) {
            wrong = judge_list(scene, own, id);
        } else if (walk.levels[id] > 0 && has_children(own, id)) {
            const u32 child = own->nodes[id].first;
            failed[child] = failed[child + 1] = count_failed(scene, &walk, own, id, failed[id]);
        }
        if (wrong.found == NULL && walk.levels[id] > 0) {
            wrong = judge_limits(scene, own, id, walk.levels[id], walk.cells[id], failed[id]);
        }
    }
    free(failed);
    walk_free(&walk);
    return wrong;
}

// How deep a tree is that can be walked down, in levels.
static int depth_of(const KdTree3D *tree)
{
    Walk walk = walk_down(tree);
    int depth = 0;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        depth = walk.levels[id] > depth ? walk.levels[id] : depth;
    }
    walk_free(&walk);
    return depth;
}

Diagnosis tree3d_judge_depth(const TreeScene3D *scene, const KdTree3D *own)
{
    const int depth = depth_of(own);
    if (depth > TODO_SIZE + 1) {
        return diagnosis_new(
            "%s, maxDepth %d: the tree has %d levels, so %d nodes may wait at once, but "
            "the todo stack has %d places: expected fits_todo() to say so",
            scene->title, scene->limits.maxDepth, depth, depth - 1, TODO_SIZE);
    }
    // So shallow a tree, which may be another task's work, asks fits_todo() for nothing.
    if (scene->tree.n_nodes == 0) {
        return diagnosis_new("%s, maxDepth %d: found a tree of %d level%s, expected kdtree3d_build "
                             "to give up below level %d, where fits_todo() says so",
                             scene->title, scene->limits.maxDepth, depth, plural((unsigned)depth),
                             TODO_SIZE);
    }
    const int expected = depth_of(&scene->tree);
    return depth == expected || scene->is_tied
               ? NOTHING_WRONG
               : diagnosis_new("%s, maxDepth %d: found a tree of %d level%s, expected one of %d",
                               scene->title, scene->limits.maxDepth, depth, plural((unsigned)depth),
                               expected);
}

int tree3d_judge_is_exact(const TreeScene3D *scene)
{
    const KdTree3D *tree = &scene->tree;
    Walk walk = walk_down(tree);
    int is_exact = 1;
    for (u32 id = 0; is_exact && id < tree->n_nodes; id++) {
        const Count count = count_spheres(scene, walk.cells[id]);
        is_exact = count.least == count.most &&
                   (is_leaf_node(tree, id) || tree3d_judge_is_exact_cell(walk.cells[id]));
    }
    walk_free(&walk);
    return is_exact;
}
