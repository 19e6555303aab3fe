// Lab 03: each answer alone, beside stand-ins for what shares its kernel (see
// tests/stand_ins/README.md).
//
// The scenes are those of the whole, under the same numbers, and their trees are right; but behind
// the nodes stand tables, in which the stand-ins look up what others work out from boxes:
//
//   nodes_Relations[n_nodes]      a leaf that is nobody's
//   nodes_Relations[TABLE_NODES]  its id, and the picture's width and height
//   behind that, u32              levels[TABLE_NODES] of the nodes, 0 the root's; then a word for
//                                 each pixel: for leaf_loop its leaf; for descent, which has to
//                                 find that, only the way there: bit i says where to go at level i
//
// So descent and leaf_loop have all that they have in the whole, and who does without the stand-in
// is as right as there.
#include "judge_03.h"

#include "complain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// As the stand-ins have it.
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
        leaves[i] = NO_LEAF;
    }
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const BBox2D box = tree->nodes_BBox[id];
        if (tree->nodes_flag[id] != LEAF) {
            continue;
        }
        for (int y = (int)fmaxf(0, ceilf(box.minY)); y < height && (float)y < box.maxY; y++) {
            for (int x = (int)fmaxf(0, ceilf(box.minX)); x < width && (float)x < box.maxX; x++) {
                leaves[y * width + x] = id;
            }
        }
    }
    return leaves;
}

// What a leaf's pixels have in their word.
static u32 word_of(u32 leaf, const u32 *ways, int is_for_descent)
{
    return is_for_descent ? ways[leaf] : leaf;
}

// Fill the tables of a tree with room for them. A pixel outside the root may end in any leaf: its
// word is that of the first.
static void fill_tables(const JobScene *scene, const u32 *leaves, int is_for_descent,
                        NodeRel *relations)
{
    const KdTree2D *tree = &scene->tree;
    const u32 width = (u32)scene->scene.width, height = (u32)scene->scene.height;
    u32 ways[TABLE_NODES] = {0}, first_leaf = NO_LEAF;
    u32 *levels = (u32 *)(relations + TABLE_NODES + 1);
    relations[TABLE_NODES] = (NodeRel){tree->n_nodes, width, height, 0};
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const u32 left = relations[id].lChild, right = relations[id].rChild;
        if (tree->nodes_flag[id] == LEAF) {
            first_leaf = first_leaf == NO_LEAF ? id : first_leaf;
            continue;
        }
        levels[left] = levels[right] = levels[id] + 1;
        ways[left] = ways[id];
        ways[right] = ways[id] | 1u << levels[id];
    }
    for (u32 i = 0; i < width * height; i++) {
        const u32 leaf = leaves[i] != NO_LEAF ? leaves[i] : first_leaf;
        levels[TABLE_NODES + i] = word_of(leaf, ways, is_for_descent);
    }
}

// The tree of a scene with the tables behind it, as long as all of that is in nodes. Free it.
// Returns 0, or -1 after one message.
static int extend_tree(const JobScene *scene, int is_for_descent, KdTree2D *tree)
{
    const KdTree2D *own = &scene->tree;
    const size_t n_pixels = (size_t)scene->scene.width * (size_t)scene->scene.height;
    const size_t n_words = TABLE_NODES + n_pixels;
    const size_t n_nodes = TABLE_NODES + 1 + (n_words + WORDS_A_NODE - 1) / WORDS_A_NODE;
    u32 *leaves = list_leaves(scene);
    *tree = (KdTree2D){.nodes_Relations = calloc(n_nodes, sizeof *tree->nodes_Relations),
                       .nodes_flag = calloc(n_nodes, sizeof *tree->nodes_flag),
                       .nodes_BBox = calloc(n_nodes, sizeof *tree->nodes_BBox),
                       .mapNode2Circles = calloc(own->n_map, sizeof *tree->mapNode2Circles),
                       .n_nodes = (u32)n_nodes,
                       .n_map = own->n_map};
    if (leaves == NULL || tree->nodes_Relations == NULL || tree->nodes_flag == NULL ||
        tree->nodes_BBox == NULL || tree->mapNode2Circles == NULL || own->n_nodes >= TABLE_NODES) {
        complain("grade: no room for tables");
        free(leaves);
        return -1;
    }
    memcpy(tree->nodes_Relations, own->nodes_Relations, own->n_nodes * sizeof(NodeRel));
    memcpy(tree->nodes_flag, own->nodes_flag, own->n_nodes);
    memcpy(tree->nodes_BBox, own->nodes_BBox, own->n_nodes * sizeof(BBox2D));
    memcpy(tree->mapNode2Circles, own->mapNode2Circles, own->n_map * sizeof(u32));
    fill_tables(scene, leaves, is_for_descent, tree->nodes_Relations);
    free(leaves);
    return 0;
}

// ---- The job ------------------------------------------------------------------------------------

static int write_scene(const JobScene *scene, int k, int is_for_descent, FILE *file)
{
    JobScene extended = *scene;
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
        const KdTree2D *tree = &job->scenes[BORDERS].tree;
        return job_section_write(file, BORDERS, "relations", tree->nodes_Relations,
                                 tree->n_nodes * sizeof *tree->nodes_Relations) |
               job_section_write(file, BORDERS, "boxes", tree->nodes_BBox,
                                 tree->n_nodes * sizeof *tree->nodes_BBox);
    }
    const int is_for_descent = strcmp(task, "descent") == 0;
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = write_scene(&job->scenes[k], k, is_for_descent, file);
    }
    return result;
}

// ---- Judging ------------------------------------------------------------------------------------

// Did every pixel of scene K end in its leaf? The stand-in of leaf_loop paints it.
int ends_in_leaves_03(const void *pointer, int k, const Sections *answers)
{
    const JobScene *scene = &((const Job03 *)pointer)->scenes[k];
    const int width = scene->scene.width, height = scene->scene.height;
    const ProbeImage own = job_picture_answer(&scene->picture, k, answers);
    u32 *leaves = own.pixels != NULL ? list_leaves(scene) : NULL;
    int is_right = leaves != NULL;
    for (int i = 0; is_right && i < width * height; i++) {
        const int x = i % width, y = i / width;
        const float color[IMAGE_CHANNELS] = {(float)leaves[i], (float)x, (float)y, 1};
        is_right = leaves[i] == NO_LEAF || is_same_color(probe_image_pixel(own, x, y), color, 0);
    }
    free(leaves);
    return is_right;
}

// The leaf map is another check's.
int all_end_in_leaves_03(const void *job, const JudgeCheck *check, const Sections *answers)
{
    int is_right = 1;
    (void)check;
    for (int k = 0; is_right && k < N_SCENES; k++) {
        is_right = k == LEAF_MAP || ends_in_leaves_03(job, k, answers);
    }
    return is_right;
}
