// Lab 03: each answer alone, beside stubs for what shares its kernel (see
// tests/stubs/README.md).
//
// The scenes are those of the whole, under the same numbers, and their trees are right; but behind
// the nodes stand tables, in which the stubs look up what others work out from boxes:
//
//   nodes_Relations[n_nodes]      a leaf that is nobody's
//   nodes_Relations[TABLE_NODES]  its id, and the picture's width and height
//   behind that, u32              by a node's id the number of the first leaf below its right
//                                 child, leaves counted from left to right; and behind TABLE_NODES
//                                 of them a word for each pixel: for leaf_loop its leaf; for
//                                 descent, which has to find that, only the leaf's number
//
// Where ids go beyond FAR_IDS, all of that is still below them, in place of the nodes that are
// nobody's, and the words of high ids come behind those of the pixels.
//
// So descent and leaf_loop have all that they have in the whole, and who does without the stub
// is as right as there.
#include "judge_03.h"

#include "complain.h"
#include "jobs.h"

#include <stdlib.h>
#include <string.h>

// As the stubs have it.
enum { TABLE_NODES = 4096, WORDS_A_NODE = sizeof(NodeRel) / sizeof(u32) };

// A pixel that no leaf holds.
#define NO_LEAF 0xffffffffu

// ---- Tables -------------------------------------------------------------------------------------

// In which leaf each pixel of the picture is. Owned by the caller; NULL after one message.
static u32 *list_leaves(const JobScene *scene)
{
    const KdTree2D *tree = &scene->tree;
    const int width = scene->scene.width, height = scene->scene.height;
    u32 *leaves = malloc((size_t)width * (size_t)height * sizeof *leaves);
    if (leaves == NULL) {
        complain("grade: no memory for a table");
        return NULL;
    }
    for (int i = 0; i < width * height; i++) {
        const u32 leaf = leaf_at(tree, i % width, i / width);
        leaves[i] = leaf < tree->n_nodes ? leaf : NO_LEAF;
    }
    return leaves;
}

// Count leaves from left to right: first[n_nodes] gets the number of the first leaf below each
// node, a leaf's own. Children have higher ids than their parent. Owned by the caller; NULL after
// one message.
static u32 *number_leaves(const KdTree2D *tree)
{
    u32 *first = calloc(tree->n_nodes, sizeof *first);
    u32 *n_leaves = calloc(tree->n_nodes, sizeof *n_leaves);
    if (first == NULL || n_leaves == NULL) {
        complain("grade: no memory for a table");
        free(first);
        first = NULL;
    }
    for (u32 id = tree->n_nodes; first != NULL && id-- > 0;) {
        const NodeRel node = tree->nodes_Relations[id];
        n_leaves[id] =
            tree->nodes_flag[id] == LEAF ? 1 : n_leaves[node.lChild] + n_leaves[node.rChild];
    }
    for (u32 id = 0; first != NULL && id < tree->n_nodes; id++) {
        const NodeRel node = tree->nodes_Relations[id];
        if (tree->nodes_flag[id] != LEAF) {
            first[node.lChild] = first[id];
            first[node.rChild] = first[id] + n_leaves[node.lChild];
        }
    }
    free(n_leaves);
    return first;
}

// Fill the tables of a tree with room for them. A pixel outside the root may end in any leaf: its
// word is that of the first.
//   leaves[height * width]   in which leaf each pixel is
//   first[n_nodes]           of number_leaves()
static void fill_tables(const JobScene *scene, const u32 *leaves, const u32 *first,
                        int is_for_descent, NodeRel *relations)
{
    const KdTree2D *tree = &scene->tree;
    const u32 width = (u32)scene->scene.width, height = (u32)scene->scene.height;
    u32 first_leaf = 0;
    u32 *table = (u32 *)(relations + TABLE_NODES + 1);
    relations[TABLE_NODES] = (NodeRel){tree->n_nodes, width, height, 0};
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] != LEAF) {
            table[id] = first[tree->nodes_Relations[id].rChild];
        }
    }
    while (tree->nodes_flag[first_leaf] != LEAF) {
        first_leaf = tree->nodes_Relations[first_leaf].lChild;
    }
    for (u32 i = 0; i < width * height; i++) {
        const u32 leaf = leaves[i] != NO_LEAF ? leaves[i] : first_leaf;
        table[TABLE_NODES + i] = is_for_descent ? first[leaf] : leaf;
    }
}

// How many nodes the arrays must have for a tree and its tables. Returns 0 after one message where
// there is no place for them.
static size_t n_with_tables(const JobScene *scene)
{
    const size_t n_own = scene->tree.n_nodes;
    const size_t n_words = TABLE_NODES + (size_t)scene->scene.width * (size_t)scene->scene.height;
    const size_t n_nodes = TABLE_NODES + 1 + (n_words + WORDS_A_NODE - 1) / WORDS_A_NODE;
    if (n_own < TABLE_NODES) {
        return n_nodes;
    }
    if (n_own > FAR_IDS && n_own < 2 * FAR_IDS && n_words <= FAR_IDS) {
        return n_own + 1;
    }
    complain("grade: a tree of %zu nodes leaves no place for tables", n_own);
    return 0;
}

// The tree of a scene with the tables, as long as all of that is in nodes. Free it. Returns 0, or
// -1 after one message.
static int extend_tree(const JobScene *scene, int is_for_descent, KdTree2D *tree)
{
    const KdTree2D *own = &scene->tree;
    const size_t n_nodes = n_with_tables(scene);
    if (n_nodes == 0) {
        return -1;
    }
    u32 *leaves = list_leaves(scene), *first = number_leaves(own);
    const int result =
        leaves != NULL && first != NULL ? tree_create_03((u32)n_nodes, own->n_map, tree) : -1;
    if (result == 0) {
        memcpy(tree->nodes_Relations, own->nodes_Relations, own->n_nodes * sizeof(NodeRel));
        memcpy(tree->nodes_flag, own->nodes_flag, own->n_nodes);
        memcpy(tree->nodes_BBox, own->nodes_BBox, own->n_nodes * sizeof(BBox2D));
        memcpy(tree->mapNode2Circles, own->mapNode2Circles, own->n_map * sizeof(u32));
        fill_tables(scene, leaves, first, is_for_descent, tree->nodes_Relations);
    }
    free(leaves);
    free(first);
    return result;
}

// ---- The job ------------------------------------------------------------------------------------

static int write_scene(const JobScene *scene, int k, int is_for_descent, FILE *file)
{
    JobScene extended = *scene;
    extended.tree = (KdTree2D){0};
    int result = extend_tree(scene, is_for_descent, &extended.tree);
    if (result == 0) {
        result = job_scene_write(&extended, k, file);
    }
    tree2d_free(&extended.tree);
    return result;
}

int write_alone_03(const void *pointer, const char *task, FILE *file)
{
    const Job03 *job = pointer;
    if (strcmp(task, "getContainingChild") == 0) {
        return write_child_tree_03(job, file);
    }
    const int is_for_descent = strcmp(task, "descent") == 0;
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = write_scene(&job->scenes[k], k, is_for_descent, file);
    }
    return result;
}

// ---- Judging ------------------------------------------------------------------------------------

// Did a pixel end in its leaf? The stub of leaf_loop paints it. Outside the root it may end in
// any leaf, or be background at once, but drawn it must be.
static int ends_in_leaf(const float *found, u32 leaf, int x, int y)
{
    const float color[IMAGE_CHANNELS] = {(float)leaf, (float)x, (float)y, 1};
    return leaf == NO_LEAF ? found[0] != UNWRITTEN : is_same_color(found, color, 0);
}

// Did every pixel of scene K?
int ends_in_leaves_03(const void *pointer, int k, const Sections *answers)
{
    const JobScene *scene = &((const Job03 *)pointer)->scenes[k];
    const int width = scene->scene.width, height = scene->scene.height;
    const ProbeImage own = job_picture_answer(&scene->picture, k, answers);
    u32 *leaves = own.pixels != NULL ? list_leaves(scene) : NULL;
    int is_right = leaves != NULL;
    for (int i = 0; is_right && i < width * height; i++) {
        const int x = i % width, y = i / width;
        is_right = ends_in_leaf(probe_image_pixel(own, x, y), leaves[i], x, y);
    }
    free(leaves);
    return is_right;
}

// The node in which each pixel of a scene ended, as the stub of leaf_loop has painted it. Owned
// by the caller; NULL where something else was painted.
static u32 *read_ends(const JobScene *scene, int k, const Sections *answers)
{
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const ProbeImage own = job_picture_answer(&scene->picture, k, answers);
    u32 *ends = own.pixels != NULL ? malloc((size_t)n_pixels * sizeof *ends) : NULL;
    int i = 0;
    for (; ends != NULL && i < n_pixels; i++) {
        const float *color = probe_image_pixel(own, i % width, i / width);
        if (!(color[0] >= 0 && color[0] < 0x1p24f) || color[1] != (float)(i % width) ||
            color[2] != (float)(i / width)) {
            break;
        }
        ends[i] = (u32)color[0];
    }
    if (i < n_pixels) {
        free(ends);
        ends = NULL;
    }
    return ends;
}

// The same mistake in both leaf maps: one alone may be explained by several.
Cause descent_cause_03(const void *pointer, const JudgeCheck *check, const Sections *answers)
{
    const Job03 *job = pointer;
    Cause causes[2] = {{0}};
    (void)check;
    for (int i = 0; i < 2; i++) {
        const int k = i == 0 ? LEAF_MAP : STAIRS;
        u32 *ends = read_ends(&job->scenes[k], k, answers);
        causes[i] = ends != NULL ? ends_look_03(&job->scenes[k], ends) : (Cause){0};
        free(ends);
    }
    const int are_right = ends_in_leaves_03(job, LEAF_MAP, answers);
    return are_right ? causes[1] : causes[0];
}
