// Right answers of labs 00 to 03, in plain C.
//
// The builder is lab 02's solution, which the grader has in it; kernels are written anew. Read
// next: right_answers_3d.h.
#ifndef UNIT_RIGHT_ANSWERS_2D_H
#define UNIT_RIGHT_ANSWERS_2D_H

#include "image.h"
#include "job_scene.h"
#include "jobs_00.h"
#include "jobs_01.h"
#include "jobs_02.h"
#include "jobs_03.h"
#include "kdtree2d_build.h"
#include "pattern.h"
#include "right_answers_sections.h"

#include <math.h>

// A scene as the probe gets it: nothing in it is copied.
static int scene_read(const Sections *job, int k, JobScene *scene)
{
    size_t n_bytes;
    const SceneJob *header = sections_find(job, numbered("scene", k, NULL), sizeof *header);
    if (header == NULL) {
        return 0;
    }
    *scene = (JobScene){.limits = {header->maxDepth, header->targetElementsPerNode}};
    scene->scene =
        (Scene2D){(Circle *)sections_find_any(job, numbered("scene", k, "circles"), &n_bytes),
                  header->n_circles, header->width, header->height};
    KdTree2D *tree = &scene->tree;
    tree->nodes_Relations =
        (NodeRel *)sections_find_any(job, numbered("scene", k, "relations"), &n_bytes);
    tree->nodes_flag = (u8 *)sections_find_any(job, numbered("scene", k, "flags"), &n_bytes);
    tree->nodes_BBox = (BBox2D *)sections_find_any(job, numbered("scene", k, "boxes"), &n_bytes);
    tree->mapNode2Circles = (u32 *)sections_find_any(job, numbered("scene", k, "map"), &n_bytes);
    return 1;
}

static u32 containing_child(const KdTree2D *tree, u32 id, float x, float y)
{
    const NodeRel node = tree->nodes_Relations[id];
    const BBox2D left = tree->nodes_BBox[node.lChild];
    return x >= left.minX && x < left.maxX && y >= left.minY && y < left.maxY ? node.lChild
                                                                              : node.rChild;
}

// A pixel's colour through the tree, or past all circles where there is none, and what it cost.
static Work draw_pixel(const JobScene *scene, int x, int y, float color[IMAGE_CHANNELS])
{
    const KdTree2D *tree = &scene->tree;
    Work work = {0};
    const u32 *ids = NULL;
    u32 n_ids = (u32)scene->scene.n_circles;
    if (tree->nodes_Relations != NULL) {
        u32 id = 0;
        for (; tree->nodes_flag[id] != LEAF; work.n_nodes_visited++) {
            id = containing_child(tree, id, (float)x, (float)y);
        }
        ids = tree->mapNode2Circles + tree->nodes_Relations[id].circleMapOffset;
        n_ids = *ids++;
    }
    float min_depth = INFINITY;
    memset(color, 0, IMAGE_CHANNELS * sizeof *color);
    for (u32 i = 0; i < n_ids; i++, work.n_tests++) {
        const Circle c = scene->scene.circles[ids ? ids[i] : i];
        const float dx = (float)x - c.x, dy = (float)y - c.y;
        if (dx * dx + dy * dy <= c.radius * c.radius && c.depth < min_depth && c.a != UNTAKEN) {
            min_depth = c.depth;
            memcpy(color, (float[]){c.r, c.g, c.b, c.a}, IMAGE_CHANNELS * sizeof *color);
        }
    }
    return work;
}

// Lab 00: one work-item for each pixel, in whole groups of 16 x 16.
static void answer_items(Writer *writer, int k, int width, int height)
{
    const int side = PROBE_IMAGE_SIDE(width);
    const size_t n_places = (size_t)side * PROBE_IMAGE_SIDE((size_t)height);
    u32 *n_items = calloc(n_places + N_ITEMS_REST, sizeof *n_items);
    for (int y = 0; y < (height + 15) / 16 * 16; y++) {
        for (int x = 0; x < (width + 15) / 16 * 16; x++) {
            n_items[y * side + x] = 1;
        }
    }
    answer(writer, numbered("items", k, NULL), n_items,
           (n_places + N_ITEMS_REST) * sizeof *n_items);
    free(n_items);
}

// Lab 00: what the host's functions do for one size.
static void answer_host(Writer *writer, const Sections *job, int k, int width, int height)
{
    const ArgumentsAnswer arguments = {0, {(float)width, (float)height, 0, 1}};
    const u32 *key = sections_find(job, numbered("scene", k, "pattern"), sizeof *key);
    const size_t n = (size_t)width * (size_t)height * 4;
    const size_t n_answers = n + N_READ_BACK_REST;
    float *pattern = malloc(n_answers * sizeof *pattern);
    for (size_t i = 0; i < n_answers; i++) {
        pattern[i] = i < n ? pattern_value(*key, (u32)i) : UNWRITTEN;
    }
    pattern[n + READ_BACK_LATE] = 0;
    answer(writer, numbered("arguments", k, NULL), &arguments, sizeof arguments);
    answer_items(writer, k, width, height);
    answer(writer, numbered("readback", k, NULL), pattern, n_answers * sizeof *pattern);
    free(pattern);
}

// The pictures of all scenes; of lab 00 what the host does, of lab 03 the work besides.
static void answer_pictures(Writer *writer, int lab, const Sections *job)
{
    JobScene scene;
    for (int k = 0; scene_read(job, k, &scene); k++) {
        const int width = scene.scene.width, height = scene.scene.height;
        const int image_width = PROBE_IMAGE_SIDE(width);
        const size_t n_pixels = (size_t)image_width * PROBE_IMAGE_SIDE((size_t)height);
        float(*image)[IMAGE_CHANNELS] = malloc(n_pixels * sizeof *image);
        Work *work = calloc(n_pixels, sizeof *work);
        for (size_t i = 0; i < n_pixels * IMAGE_CHANNELS; i++) {
            image[i / IMAGE_CHANNELS][i % IMAGE_CHANNELS] = UNWRITTEN;
        }
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float *pixel = image[y * image_width + x];
                if (lab == 0) {
                    memcpy(pixel,
                           (float[]){(float)x / (float)width, (float)y / (float)height, 0.25f, 1},
                           sizeof *image);
                } else {
                    work[y * width + x] = draw_pixel(&scene, x, y, pixel);
                }
            }
        }
        answer(writer, numbered("picture", k, NULL), image, n_pixels * sizeof *image);
        if (lab == 0) {
            answer_host(writer, job, k, width, height);
        }
        // The scenes whose work is judged: a wide one, one with empty leaves, one whose root is a
        // leaf, and one with a long list.
        if (lab == 3 && (k == 3 || k == 7 || k == 10 || k == 13)) {
            answer(writer, numbered("work", k, NULL), work, n_pixels * sizeof *work);
        }
        free(work);
        free(image);
    }
}

static void answer_overlaps(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const OverlapJob *inputs = sections_find_any(job, "overlaps", &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const Circle c = inputs[i].circle;
        const float dx = (float)inputs[i].x - c.x, dy = (float)inputs[i].y - c.y;
        answers[i] = dx * dx + dy * dy <= c.radius * c.radius && c.depth < inputs[i].minDepth;
    }
    answer(writer, "overlaps", answers, n * sizeof *answers);
    free(answers);
}

static void answer_leaves_and_boxes(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const LeafJob *leaves = sections_find_any(job, "leaves", &n_bytes);
    size_t n = n_bytes / sizeof *leaves;
    i32 *decisions = calloc(n, sizeof *decisions);
    for (size_t i = 0; i < n; i++) {
        decisions[i] = is_leaf(leaves[i].level, leaves[i].n_circles, leaves[i].n_failed,
                               (KdTreeLimits){leaves[i].maxDepth, leaves[i].targetElementsPerNode});
    }
    answer(writer, "leaves", decisions, n * sizeof *decisions);
    free(decisions);

    const BBox2D *boxes = sections_find_any(job, "splits", &n_bytes);
    n = n_bytes / sizeof *boxes;
    BBox2D(*halves)[2] = calloc(n, sizeof *halves);
    for (size_t i = 0; i < n; i++) {
        split_box(boxes[i], &halves[i][0], &halves[i][1]);
    }
    answer(writer, "splits", halves, n * sizeof *halves);
    free(halves);

    const BoxOverlapJob *pairs = sections_find_any(job, "overlaps", &n_bytes);
    n = n_bytes / sizeof *pairs;
    decisions = calloc(n, sizeof *decisions);
    for (size_t i = 0; i < n; i++) {
        decisions[i] = circle_overlaps_box(pairs[i].circle, pairs[i].box);
    }
    answer(writer, "overlaps", decisions, n * sizeof *decisions);
    free(decisions);
}

static void answer_lists(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    JobScene scene;
    cr_assert(scene_read(job, DISTRIBUTE_SCENE, &scene));
    const DistributeJob *nodes = sections_find_any(job, "distribute", &n_bytes);
    size_t n = n_bytes / sizeof *nodes;
    u32(*lists)[DISTRIBUTE_ROOM] = calloc(n, sizeof *lists);
    for (size_t i = 0; i < n; i++) {
        for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
            lists[i][j] = UNTOUCHED;
        }
        lists[i][0] = distribute(scene.scene.circles, nodes[i].ids, nodes[i].n_ids, nodes[i].child,
                                 lists[i] + 1);
    }
    answer(writer, "distribute", lists, n * sizeof *lists);
    free(lists);

    const PackJob *leaves = sections_find_any(job, "pack", &n_bytes);
    n = n_bytes / sizeof *leaves;
    PackAnswer *packed = calloc(n, sizeof *packed);
    for (size_t i = 0; i < n; i++) {
        u8 flags[PACK_NODES];
        for (u32 id = 0; id < PACK_NODES; id++) {
            packed[i].relations[id].id = id;
            packed[i].boxes[id] = PACK_CELL(id);
            flags[id] = INNER;
        }
        for (int j = 0; j < PACK_MAP_ROOM; j++) {
            packed[i].map[j] = UNTOUCHED;
        }
        KdTree2D tree = {packed[i].relations, flags,      packed[i].boxes,
                         packed[i].map,       PACK_NODES, leaves[i].n_before};
        pack_leaf(&tree, leaves[i].id, leaves[i].ids, leaves[i].n_ids);
        packed[i].n_map = tree.n_map;
        packed[i].n_nodes = tree.n_nodes;
        for (u32 id = 0; id < PACK_NODES; id++) {
            packed[i].flags[id] = flags[id];
        }
    }
    answer(writer, "pack", packed, n * sizeof *packed);
    free(packed);
}

static void answer_trees(Writer *writer, const Sections *job)
{
    JobScene scene;
    for (int k = 0; scene_read(job, k, &scene); k++) {
        KdTree2D tree;
        cr_assert_eq(
            kdtree2d_build(scene.scene.circles, (u32)scene.scene.n_circles, scene.limits, &tree),
            0);
        const TreeAnswer header = {tree.n_nodes, tree.n_map};
        answer(writer, numbered("tree", k, NULL), &header, sizeof header);
        answer(writer, numbered("tree", k, "relations"), tree.nodes_Relations,
               tree.n_nodes * sizeof *tree.nodes_Relations);
        answer(writer, numbered("tree", k, "flags"), tree.nodes_flag, tree.n_nodes);
        answer(writer, numbered("tree", k, "boxes"), tree.nodes_BBox,
               tree.n_nodes * sizeof *tree.nodes_BBox);
        answer(writer, numbered("tree", k, "map"), tree.mapNode2Circles, tree.n_map * sizeof(u32));
        tree2d_free(&tree);
    }
}

static void answer_children(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    NodeRel *relations = (NodeRel *)sections_find_any(job, "children.relations", &n_bytes);
    BBox2D *boxes = (BBox2D *)sections_find_any(job, "children.boxes", &n_bytes);
    const ChildJob *inputs = sections_find_any(job, "children", &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    u32 *children = calloc(n, sizeof *children);
    for (size_t i = 0; i < n; i++) {
        const KdTree2D tree = {.nodes_Relations = relations + inputs[i].first,
                               .nodes_BBox = boxes + inputs[i].first};
        children[i] = containing_child(&tree, inputs[i].id, (float)inputs[i].x, (float)inputs[i].y);
    }
    answer(writer, "children", children, n * sizeof *children);
    free(children);
}
#endif
