// Tree invariants, checked in double precision with the oracle's overlap test.
#include "tree_judge.h"

#include "job_sections.h"
#include "jobs_02.h"
#include "message.h"
#include "oracle2d.h"
#include "oracle2d_tree.h"
#include "words.h"

#include <stdlib.h>
#include <string.h>

int tree_judge_answer(int k, const Sections *answers, KdTree2D *own)
{
    const TreeAnswer *answer = job_section_find(answers, "tree", k, sizeof *answer);
    if (answer == NULL || answer->n_nodes == 0) {
        return 0;
    }
    const size_t n_nodes = answer->n_nodes, n_map = answer->n_map;
    const void *relations =
        job_part_find(answers, "tree", k, "relations", n_nodes * sizeof(NodeRel));
    const void *flags = job_part_find(answers, "tree", k, "flags", n_nodes * sizeof(u8));
    const void *boxes = job_part_find(answers, "tree", k, "boxes", n_nodes * sizeof(BBox2D));
    const void *map = job_part_find(answers, "tree", k, "map", n_map * sizeof(u32));
    // The judge only reads: the casts take no const away that matters.
    *own = (KdTree2D){(NodeRel *)relations, (u8 *)flags,  (BBox2D *)boxes,
                      (u32 *)map,           (u32)n_nodes, (u32)n_map};
    return relations != NULL && flags != NULL && boxes != NULL && map != NULL;
}

// ---- Reading a tree without trusting it -------------------------------------------------------

static int is_inner(const KdTree2D *tree, u32 id)
{
    return tree->nodes_flag[id] != LEAF;
}

// Are both children there, behind their parent?
static int has_children(const KdTree2D *tree, u32 id)
{
    const NodeRel node = tree->nodes_Relations[id];
    return node.lChild > id && node.rChild > id && node.lChild < tree->n_nodes &&
           node.rChild < tree->n_nodes;
}

static const char *entries(u32 n)
{
    return n == 1 ? "entry" : "entries";
}

// A leaf's list: the ids, and how many; NULL when offset or count lead out of the map.
static const u32 *leaf_list(const KdTree2D *tree, u32 id, u32 *n_ids)
{
    const u32 offset = tree->nodes_Relations[id].circleMapOffset;
    if (offset >= tree->n_map || tree->mapNode2Circles[offset] > tree->n_map - offset - 1) {
        return NULL;
    }
    *n_ids = tree->mapNode2Circles[offset];
    return tree->mapNode2Circles + offset + 1;
}

static Diagnosis bad_list(const JobScene *scene, const KdTree2D *own, u32 id)
{
    const u32 offset = own->nodes_Relations[id].circleMapOffset;
    if (offset >= own->n_map) {
        return diagnosis_new("%s: leaf %u: circleMapOffset is %u, but mapNode2Circles has %u %s",
                             scene->picture.title, id, offset, own->n_map, entries(own->n_map));
    }
    return diagnosis_new("%s: leaf %u: circleMapOffset is %u, where the count would be %u, but "
                         "mapNode2Circles has %u %s",
                         scene->picture.title, id, offset, own->mapNode2Circles[offset], own->n_map,
                         entries(own->n_map));
}

// The invariants hold for the tree by itself; is it also the tree that was asked for?
static Diagnosis differs_from_oracle(const JobScene *scene, const KdTree2D *own,
                                     const void *own_array, const void *array, size_t element_size,
                                     const char *what)
{
    if (own->n_nodes != scene->tree.n_nodes) {
        return diagnosis_new("%s: the tree has %u node%s, expected %u", scene->picture.title,
                             own->n_nodes, plural(own->n_nodes), scene->tree.n_nodes);
    }
    for (u32 id = 0; id < own->n_nodes; id++) {
        if (memcmp((const char *)own_array + id * element_size,
                   (const char *)array + id * element_size, element_size) != 0) {
            return diagnosis_new("%s: node %u: %s is not as expected", scene->picture.title, id,
                                 what);
        }
    }
    return NOTHING_WRONG;
}

// How many nodes are looked at where each is held against every circle. As long as ids are
// breadth-first the first wrong node is among as many as the oracle's tree has; a million more
// would only take hours.
static u32 n_judged(const JobScene *scene, const KdTree2D *own)
{
    return own->n_nodes < scene->tree.n_nodes ? own->n_nodes : scene->tree.n_nodes;
}

// ---- The properties ---------------------------------------------------------------------------

// What is above a node, which the arrays do not say.
typedef struct Above {
    int n_levels;
    int n_failed;  // splits that failed
} Above;

Diagnosis tree_judge_limits(const JobScene *scene, const KdTree2D *own)
{
    Diagnosis wrong = NOTHING_WRONG;
    Above *above = calloc(own->n_nodes, sizeof *above);
    for (u32 id = 0; above != NULL && wrong.found == NULL && id < n_judged(scene, own); id++) {
        const int level = above[id].n_levels + 1, n_failed = above[id].n_failed;
        const u32 n = oracle2d_n_overlapping(&scene->scene, own->nodes_BBox[id]);
        const int should_be_leaf = oracle_is_leaf(level, n, n_failed, scene->limits);
        if (is_inner(own, id) == should_be_leaf) {
            wrong = diagnosis_new(
                "%s, maxDepth %d, targetElementsPerNode %d: node %u on level %d with "
                "%u circle%s, below %d failed split%s, is %s, expected %s",
                scene->picture.title, scene->limits.maxDepth, scene->limits.targetElementsPerNode,
                id, level, n, plural(n), n_failed, plural((unsigned)n_failed),
                is_inner(own, id) ? "split" : "a leaf",
                should_be_leaf ? "a leaf" : "it to be split");
        } else if (is_inner(own, id) && has_children(own, id)) {
            const u32 lChild = own->nodes_Relations[id].lChild;
            const u32 rChild = own->nodes_Relations[id].rChild;
            const int fails = oracle_split_fails(
                n, oracle2d_n_overlapping(&scene->scene, own->nodes_BBox[lChild]),
                oracle2d_n_overlapping(&scene->scene, own->nodes_BBox[rChild]));
            above[lChild] = above[rChild] = (Above){level, n_failed + fails};
        }
    }
    free(above);
    return wrong.found != NULL
               ? wrong
               : differs_from_oracle(scene, own, own->nodes_flag, scene->tree.nodes_flag,
                                     sizeof *own->nodes_flag, "leaf or inner node");
}

static int is_same_box(BBox2D a, BBox2D b)
{
    return a.minX == b.minX && a.maxX == b.maxX && a.minY == b.minY && a.maxY == b.maxY;
}

Diagnosis tree_judge_cells(const JobScene *scene, const KdTree2D *own)
{
    for (u32 id = 0; id < own->n_nodes; id++) {
        if (!is_inner(own, id)) {
            continue;
        }
        if (!has_children(own, id)) {
            return diagnosis_new(
                "%s: node %u is an inner node, but its children are %u and %u of %u "
                "nodes",
                scene->picture.title, id, own->nodes_Relations[id].lChild,
                own->nodes_Relations[id].rChild, own->n_nodes);
        }
        BBox2D halves[2];
        oracle2d_halves(own->nodes_BBox[id], halves);
        const NodeRel node = own->nodes_Relations[id];
        for (int side = 0; side < 2; side++) {
            const u32 child = side == 0 ? node.lChild : node.rChild;
            const BBox2D found = own->nodes_BBox[child];
            if (!is_same_box(found, halves[side])) {
                return diagnosis_new("%s: node %u's child %u: found %s, expected %s",
                                     scene->picture.title, id, child, words_box2d(found).text,
                                     words_box2d(halves[side]).text);
            }
        }
    }
    return differs_from_oracle(scene, own, own->nodes_BBox, scene->tree.nodes_BBox,
                               sizeof *own->nodes_BBox, "the cell");
}

// Does a leaf list a circle if, and only if, that overlaps its cell?
static Diagnosis judge_listed(const JobScene *scene, const KdTree2D *own, u32 id, u32 circle,
                              int is_listed)
{
    const BBox2D box = own->nodes_BBox[id];
    const int overlaps = oracle2d_overlaps_box(scene->scene.circles[circle], box);
    if (is_listed == overlaps) {
        return NOTHING_WRONG;
    }
    char *found = message_new("%s: leaf %u, %s: circle %u at %s %s, but the leaf %s it",
                              scene->picture.title, id, words_box2d(box).text, circle,
                              words_circle(scene->scene.circles[circle]).text,
                              overlaps ? "overlaps its cell" : "does not overlap it",
                              is_listed ? "lists" : "does not list");
    return diagnosis_of(found,
                        (Cause){.mistake = is_listed ? MISTAKE_NONE : MISTAKE_MISSING_IN_CELL});
}

// Compare one leaf's list with the circles that overlap its cell.
static Diagnosis judge_leaf_overlap(const JobScene *scene, const KdTree2D *own, u32 id)
{
    u32 n_ids = 0;
    const u32 *ids = leaf_list(own, id, &n_ids);
    if (ids == NULL) {
        return bad_list(scene, own, id);
    }
    if (n_ids > (u32)scene->scene.n_circles) {
        return diagnosis_new("%s: leaf %u lists %u circle%s, but the scene has %d",
                             scene->picture.title, id, n_ids, plural(n_ids),
                             scene->scene.n_circles);
    }
    char *is_listed = calloc((size_t)scene->scene.n_circles + 1, 1);
    Diagnosis wrong = NOTHING_WRONG;
    for (u32 i = 0; is_listed != NULL && i < n_ids; i++) {
        if (ids[i] < (u32)scene->scene.n_circles) {
            is_listed[ids[i]] = 1;
        }
    }
    for (u32 circle = 0;
         is_listed != NULL && wrong.found == NULL && circle < (u32)scene->scene.n_circles;
         circle++) {
        wrong = judge_listed(scene, own, id, circle, is_listed[circle]);
    }
    free(is_listed);
    return wrong;
}

Diagnosis tree_judge_overlap(const JobScene *scene, const KdTree2D *own)
{
    for (u32 id = 0; id < n_judged(scene, own); id++) {
        const Diagnosis wrong =
            is_inner(own, id) ? NOTHING_WRONG : judge_leaf_overlap(scene, own, id);
        if (wrong.found != NULL) {
            return wrong;
        }
    }
    return differs_from_oracle(scene, own, own->nodes_BBox, scene->tree.nodes_BBox,
                               sizeof *own->nodes_BBox, "the cell");
}

// Does a leaf's list name circles of the scene, in ascending order?
static Diagnosis judge_list(const JobScene *scene, const KdTree2D *own, u32 id)
{
    u32 n_ids = 0;
    const u32 *ids = leaf_list(own, id, &n_ids);
    if (ids == NULL) {
        return bad_list(scene, own, id);
    }
    for (u32 i = 0; i < n_ids; i++) {
        if (ids[i] >= (u32)scene->scene.n_circles) {
            return diagnosis_new("%s: leaf %u lists circle %u, but the scene has %d",
                                 scene->picture.title, id, ids[i], scene->scene.n_circles);
        }
        if (i > 0 && ids[i] <= ids[i - 1]) {
            return diagnosis_new("%s: leaf %u lists circle %u after circle %u: the ids must ascend",
                                 scene->picture.title, id, ids[i], ids[i - 1]);
        }
    }
    return NOTHING_WRONG;
}

// The lists of all leaves.
static Diagnosis judge_lists(const JobScene *scene, const KdTree2D *own)
{
    Diagnosis wrong = NOTHING_WRONG;
    for (u32 id = 0; wrong.found == NULL && id < own->n_nodes; id++) {
        wrong = is_inner(own, id) ? NOTHING_WRONG : judge_list(scene, own, id);
    }
    return wrong;
}

// Is every entry of mapNode2Circles the right one? Whoever hands on a list may put a circle in the
// place of another.
static Diagnosis judge_entries(const JobScene *scene, const KdTree2D *own)
{
    const u32 *expected = scene->tree.mapNode2Circles;
    for (u32 i = 0; i < own->n_map && i < scene->tree.n_map; i++) {
        if (own->mapNode2Circles[i] != expected[i]) {
            return diagnosis_new("%s: mapNode2Circles[%u] is %u, expected %u", scene->picture.title,
                                 i, own->mapNode2Circles[i], expected[i]);
        }
    }
    return NOTHING_WRONG;
}

Diagnosis tree_judge_lists(const JobScene *scene, const KdTree2D *own)
{
    const Diagnosis wrong = judge_lists(scene, own);
    if (wrong.found != NULL) {
        return wrong;
    }
    if (own->n_map != scene->tree.n_map) {
        return diagnosis_new("%s: mapNode2Circles has %u %s, expected %u", scene->picture.title,
                             own->n_map, entries(own->n_map), scene->tree.n_map);
    }
    const Diagnosis other = differs_from_oracle(scene, own, own->nodes_flag, scene->tree.nodes_flag,
                                                sizeof *own->nodes_flag, "leaf or inner node");
    return other.found != NULL ? other : judge_entries(scene, own);
}

Diagnosis tree_judge_packing(const JobScene *scene, const KdTree2D *own)
{
    u32 next_id = 1, next_offset = 0;
    for (u32 id = 0; id < own->n_nodes; id++) {
        const NodeRel node = own->nodes_Relations[id];
        u32 n_ids = 0;
        if (node.id != id) {
            return diagnosis_new("%s: the node at position %u has id %u", scene->picture.title, id,
                                 node.id);
        }
        if (is_inner(own, id)) {
            if (node.lChild == 0 && node.rChild == 0) {
                return diagnosis_of(message_new("%s: node %u is marked INNER and has no children",
                                                scene->picture.title, id),
                                    (Cause){.says = "pack_leaf marks the leaves"});
            }
            if (node.lChild != next_id || node.rChild != next_id + 1) {
                return diagnosis_new("%s: node %u's children are %u and %u, expected %u and %u "
                                     "(breadth-first)",
                                     scene->picture.title, id, node.lChild, node.rChild, next_id,
                                     next_id + 1);
            }
            next_id += 2;
            continue;
        }
        if (leaf_list(own, id, &n_ids) == NULL) {
            return bad_list(scene, own, id);
        }
        if (node.circleMapOffset != next_offset) {
            return diagnosis_new(
                "%s: leaf %u: circleMapOffset is %u, expected %u, behind the list of the "
                "leaf before it",
                scene->picture.title, id, node.circleMapOffset, next_offset);
        }
        next_offset += n_ids + 1;
    }
    if (next_id != own->n_nodes || next_offset != own->n_map) {
        return diagnosis_new(
            "%s: %u node%s and %u map %s belong to the tree, but its arrays hold %u "
            "and %u",
            scene->picture.title, next_id, plural(next_id), next_offset, entries(next_offset),
            own->n_nodes, own->n_map);
    }
    const Diagnosis wrong = judge_lists(scene, own);
    if (wrong.found != NULL) {
        return wrong;
    }
    const Diagnosis other =
        differs_from_oracle(scene, own, own->nodes_Relations, scene->tree.nodes_Relations,
                            sizeof *own->nodes_Relations, "its entry in nodes_Relations");
    return other.found != NULL ? other : judge_entries(scene, own);
}
