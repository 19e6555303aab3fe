// Tree invariants in 3D, checked in double precision. What one call of a student's function must
// give is in tree3d_judge_steps.c.
#include "tree3d_judge.h"

#include "complain.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
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

// ---- Reading a tree without trusting it -------------------------------------------------------

static int is_leaf_node(const KdTree3D *tree, u32 id)
{
    return tree->nodes[id].split_axis == KD_LEAF;
}

// Can one go on from an inner node: an axis, and both children there, behind it?
static int has_children(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    return node.split_axis < 3 && node.first > id && node.first < tree->n_nodes - 1;
}

// The ids of a leaf, or NULL when its range leads out of the array.
static const u32 *leaf_ids(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    return node.first <= tree->n_sphere_ids && node.n_spheres <= tree->n_sphere_ids - node.first
               ? tree->sphere_ids + node.first
               : NULL;
}

static Diagnosis bad_range(const TreeScene3D *scene, const KdTree3D *own, u32 id)
{
    return diagnosis_new("%s: leaf %u: first is %u and n_spheres %u, but sphere_ids has %u entries",
                         scene->title, id, own->nodes[id].first, own->nodes[id].n_spheres,
                         own->n_sphere_ids);
}

// What the nodes do not hold: where each node's cell is, and on which level; 0 where no way leads.
typedef struct Walk {
    BBox3D *cells;  // [n_nodes]
    int *levels;    // [n_nodes]
} Walk;

static void walk_free(Walk *walk)
{
    free(walk->cells);
    free(walk->levels);
}

// Walk down from the root; a parent comes before its children.
static Walk walk_down(const KdTree3D *tree)
{
    Walk walk = {calloc((size_t)tree->n_nodes + 1, sizeof *walk.cells),
                 calloc((size_t)tree->n_nodes + 1, sizeof *walk.levels)};
    if (walk.cells == NULL || walk.levels == NULL) {
        complain("grade: no memory for a tree");
        exit(2);
    }
    walk.cells[0] = tree->bounds;
    walk.levels[0] = 1;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const KdNode3 node = tree->nodes[id];
        if (walk.levels[id] == 0 || is_leaf_node(tree, id) || !has_children(tree, id)) {
            continue;
        }
        walk.cells[node.first] = walk.cells[node.first + 1] = walk.cells[id];
        walk.cells[node.first].max[node.split_axis] = node.split_pos;
        walk.cells[node.first + 1].min[node.split_axis] = node.split_pos;
        walk.levels[node.first] = walk.levels[node.first + 1] = walk.levels[id] + 1;
    }
    return walk;
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
    const u32 n = n_judged(scene, own);
    Walk walk = walk_down(own);
    Diagnosis wrong = NOTHING_WRONG;
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
    }
    walk_free(&walk);
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
        return diagnosis_new("%s: leaf %u lists %u spheres, but the scene has %u", scene->title, id,
                             own->nodes[id].n_spheres, n_spheres);
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

// Does a leaf's list ascend? Its range is in the array.
static Diagnosis judge_order(const TreeScene3D *scene, const KdTree3D *own, u32 id)
{
    const u32 *ids = leaf_ids(own, id);
    for (u32 i = 1; i < own->nodes[id].n_spheres; i++) {
        if (ids[i] <= ids[i - 1]) {
            return diagnosis_new("%s: leaf %u lists sphere %u after sphere %u: the ids must ascend",
                                 scene->title, id, ids[i], ids[i - 1]);
        }
    }
    return NOTHING_WRONG;
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

// Where no right solution can differ: the first node or id that is not the expected one.
static Diagnosis judge_equal(const TreeScene3D *scene, const KdTree3D *own)
{
    const KdTree3D *tree = &scene->tree;
    if (own->n_nodes != tree->n_nodes || own->n_sphere_ids != tree->n_sphere_ids) {
        return diagnosis_new("%s: the tree has %u node%s and %u id%s, expected %u and %u",
                             scene->title, own->n_nodes, plural(own->n_nodes), own->n_sphere_ids,
                             plural(own->n_sphere_ids), tree->n_nodes, tree->n_sphere_ids);
    }
    for (u32 id = 0; id < own->n_nodes; id++) {
        const KdNode3 found = own->nodes[id], expected = tree->nodes[id];
        const int same_plane = found.split_axis == KD_LEAF || found.split_pos == expected.split_pos;
        if (found.split_axis != expected.split_axis || !same_plane ||
            found.first != expected.first || found.n_spheres != expected.n_spheres) {
            return diagnosis_new("%s: node %u: found split_axis %u, split_pos %s, first %u, "
                                 "n_spheres %u, expected %u, %s, %u, %u",
                                 scene->title, id, found.split_axis,
                                 words_float(found.split_pos).text, found.first, found.n_spheres,
                                 expected.split_axis, words_float(expected.split_pos).text,
                                 expected.first, expected.n_spheres);
        }
    }
    for (u32 i = 0; i < own->n_sphere_ids; i++) {
        if (own->sphere_ids[i] != tree->sphere_ids[i]) {
            return diagnosis_new("%s: sphere_ids[%u] is %u, expected %u", scene->title, i,
                                 own->sphere_ids[i], tree->sphere_ids[i]);
        }
    }
    return NOTHING_WRONG;
}

Diagnosis tree3d_judge_packing(const TreeScene3D *scene, const KdTree3D *own)
{
    u32 next_child = 1, next_id = 0;
    for (u32 id = 0; id < own->n_nodes; id++) {
        const KdNode3 node = own->nodes[id];
        if (is_leaf_node(own, id)) {
            if (leaf_ids(own, id) == NULL) {
                return bad_range(scene, own, id);
            }
            if (node.first != next_id) {
                return diagnosis_new("%s: leaf %u: first is %u, expected %u, behind the ids of the "
                                     "leaf before it",
                                     scene->title, id, node.first, next_id);
            }
            const Diagnosis wrong = judge_order(scene, own, id);
            if (wrong.found != NULL) {
                return wrong;
            }
            next_id += node.n_spheres;
            continue;
        }
        if (node.split_axis > KD_LEAF || node.n_spheres != 0) {
            return diagnosis_new("%s: node %u: split_axis is %u and n_spheres %u, expected an axis "
                                 "and 0, or KD_LEAF (%d)",
                                 scene->title, id, node.split_axis, node.n_spheres, KD_LEAF);
        }
        if (node.first != next_child) {
            const char *looks =
                node.first <= id ? "is it a leaf that is not marked KD_LEAF?" : NULL;
            return diagnosis_of(message_new("%s: node %u's children are %u and %u, expected %u and "
                                            "%u (breadth-first)",
                                            scene->title, id, node.first, node.first + 1,
                                            next_child, next_child + 1),
                                (Cause){.says = looks});
        }
        next_child += 2;
    }
    if (next_child != own->n_nodes || next_id != own->n_sphere_ids) {
        return diagnosis_new(
            "%s: %u node%s and %u id%s belong to the tree, but its arrays hold %u and "
            "%u",
            scene->title, next_child, plural(next_child), next_id, plural(next_id), own->n_nodes,
            own->n_sphere_ids);
    }
    return scene->is_exact ? judge_equal(scene, own) : NOTHING_WRONG;
}

Diagnosis tree3d_judge_depth(const TreeScene3D *scene, const KdTree3D *own)
{
    Walk walk = walk_down(own);
    int depth = 0;
    for (u32 id = 0; id < own->n_nodes; id++) {
        depth = walk.levels[id] > depth ? walk.levels[id] : depth;
    }
    walk_free(&walk);
    if (depth <= TODO_SIZE + 1) {
        return NOTHING_WRONG;
    }
    return diagnosis_new(
        "%s, maxDepth %d: the tree has %d levels, so %d nodes may wait at once, but "
        "the todo stack has %d places: expected fits_todo() to say so",
        scene->title, scene->limits.maxDepth, depth, depth - 1, TODO_SIZE);
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
